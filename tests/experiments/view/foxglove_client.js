// SPDX-License-Identifier: BSD-3-Clause
// node foxglove_client.js URL: subscribes to every channel by Foxglove's own client until the run is
// finished; prints what it was told as JSON.
const {FoxgloveClient} = require("@foxglove/ws-protocol");
const {WebSocket} = require("ws");

const client = new FoxgloveClient(
    {ws: new WebSocket(process.argv[2], [FoxgloveClient.SUPPORTED_SUBPROTOCOL])});
const told = {info: null, channels: {}, statuses: []};
const topics = new Map();  // by subscription

client.on("serverInfo", (info) => { told.info = info; });
client.on("status", (status) => told.statuses.push(status.message));
client.on("advertise", (channels) => {
  for (const {id, topic, encoding, schemaName, schemaEncoding, schema} of channels) {
    told.channels[topic] = {encoding, schemaName, schemaEncoding, schema: JSON.parse(schema), messages: 0};
    topics.set(client.subscribe(id), topic);
  }
});
client.on("message", ({subscriptionId, timestamp, data}) => {
  const channel = told.channels[topics.get(subscriptionId)];
  ++channel.messages;
  channel.timestamp_ns = String(timestamp);
  channel.last = JSON.parse(new TextDecoder().decode(data));
});
client.on("error", (error) => {
  console.error(error);
  process.exit(1);
});
client.on("close", () => console.log(JSON.stringify(told)));
