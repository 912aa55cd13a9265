// SPDX-License-Identifier: BSD-3-Clause
// node independent_mcap.js read FILE          prints the messages as JSON
// node independent_mcap.js write FILE KIND    writes scans and odometry
const fs = require("fs");
const {McapStreamReader, McapWriter} = require("@mcap/core");
const {MessageReader, MessageWriter} = require("@foxglove/rosmsg2-serialization");

// The text of a definition, for the serialization.
function parse(text) {
  return text.split(/^=+\n/m).map((part) => {
    const lines = part.split("\n").filter((line) => line !== "");
    const name = lines[0].startsWith("MSG: ") ? lines.shift().slice(5) : undefined;
    const definitions = lines.map((line) => {
      const [, type, array, count, field] = line.match(/^([^ \[]+)(\[(\d*)\])? (.+)$/);
      const is_time = type === "builtin_interfaces/Time";
      return {
        name: field,
        type: is_time ? "time" : type,
        isComplex: type.includes("/") && !is_time,
        isArray: array !== undefined,
        arrayLength: count ? Number(count) : undefined,
      };
    });
    return {name, definitions};
  });
}

function read(path) {
  const reader = new McapStreamReader();
  reader.append(fs.readFileSync(path));
  const schemas = new Map(), channels = new Map(), messages = [];
  for (let record; (record = reader.nextRecord());) {
    if (record.type === "Schema") schemas.set(record.id, record);
    if (record.type === "Channel") {
      const schema = schemas.get(record.schemaId);
      const definition = parse(new TextDecoder().decode(schema.data));
      channels.set(record.id, {topic: record.topic, reader: new MessageReader(definition)});
    }
    if (record.type !== "Message") continue;
    const {topic, reader: of_topic} = channels.get(record.channelId);
    messages.push({topic, message: of_topic.readMessage(record.data)});
  }
  const plain = (key, value) => (ArrayBuffer.isView(value) ? Array.from(value) : value);
  console.log(JSON.stringify(messages, plain));
}

const HEADER =
    "================\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" +
    "================\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n";
const SCAN =
    "std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n" +
    "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n" +
    "float32[] ranges\nfloat32[] intensities\n" + HEADER;
const VECTOR = "float64 x\nfloat64 y\nfloat64 z\n";
const ODOMETRY =
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n" +
    "geometry_msgs/TwistWithCovariance twist\n" +
    "================\nMSG: geometry_msgs/PoseWithCovariance\n" +
    "geometry_msgs/Pose pose\nfloat64[36] covariance\n" +
    "================\nMSG: geometry_msgs/Pose\n" +
    "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n" +
    "================\nMSG: geometry_msgs/Point\n" + VECTOR +
    "================\nMSG: geometry_msgs/Quaternion\n" + VECTOR + "float64 w\n" +
    "================\nMSG: geometry_msgs/TwistWithCovariance\n" +
    "geometry_msgs/Twist twist\nfloat64[36] covariance\n" +
    "================\nMSG: geometry_msgs/Twist\n" +
    "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n" +
    "================\nMSG: geometry_msgs/Vector3\n" + VECTOR + HEADER;

async function write(path, kind) {
  const pieces = [];
  let size = 0n;
  const writable = {
    position: () => size,
    write: async (bytes) => {
      pieces.push(Buffer.from(bytes));
      size += BigInt(bytes.length);
    },
  };
  const no_summary = kind === "no_summary";
  const writer = new McapWriter({
    writable,
    chunkSize: 20000,
    useChunks: kind !== "no_chunks",
    useMessageIndex: kind !== "no_index",
    useChunkIndex: kind !== "no_index" && !no_summary,
    useStatistics: !no_summary,
    useSummaryOffsets: !no_summary,
    repeatChannels: !no_summary && kind !== "no_channels",
    repeatSchemas: !no_summary,
  });
  await writer.start({profile: "ros2", library: "test"});
  const channels = [];
  for (const [topic, name, text] of [["/scan", "sensor_msgs/msg/LaserScan", SCAN],
                                     ["/odom", "nav_msgs/msg/Odometry", ODOMETRY]]) {
    const schemaId = await writer.registerSchema(
        {name, encoding: "ros2msg", data: new TextEncoder().encode(text)});
    const id = await writer.registerChannel(
        {topic, schemaId, messageEncoding: "cdr", metadata: new Map()});
    channels.push({id, writer: new MessageWriter(parse(text))});
  }
  for (let i = 0; i < 300; ++i) {
    const header = {stamp: {sec: 100 + i, nanosec: 500}, frame_id: "base_link"};
    const ranges = [];
    for (let k = 0; k < 91; ++k) ranges.push(2 + 0.01 * ((k * 7 + i) % 50));
    const scan = {header, angle_min: -1, angle_max: 0.8, angle_increment: 0.02, time_increment: 0,
                  scan_time: 0, range_min: 0.1, range_max: 30, ranges, intensities: []};
    const odometry = {
      header: {...header, frame_id: "odom"}, child_frame_id: "base_link",
      pose: {pose: {position: {x: 0.125 * i, y: 0, z: 0}, orientation: {x: 0, y: 0, z: 0, w: 1}},
             covariance: new Float64Array(36)},
      twist: {twist: {linear: {x: 0, y: 0, z: 0}, angular: {x: 0, y: 0, z: 0}},
              covariance: new Float64Array(36)},
    };
    const logTime = BigInt(100 + i) * 1000000000n;
    for (const [channel, message] of [[channels[1], odometry], [channels[0], scan]]) {
      await writer.addMessage({channelId: channel.id, sequence: i, logTime, publishTime: logTime,
                               data: channel.writer.writeMessage(message)});
    }
  }
  await writer.end();
  fs.writeFileSync(path, Buffer.concat(pieces));
}

const [command, path, kind] = process.argv.slice(2);
if (command === "read") {
  read(path);
} else {
  write(path, kind).catch((error) => {
    console.error(error);
    process.exit(1);
  });
}
