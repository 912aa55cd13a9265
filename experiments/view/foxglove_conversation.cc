// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/foxglove_conversation.h"

#include <string>
#include <utility>

#include "experiments/conversion/message_bytes.h"
#include "experiments/view/client_message.h"
#include "experiments/view/foxglove_topics.h"
#include "experiments/view/foxglove_values.h"

namespace gmapping_spa::view {
namespace {

using conversion::AppendNumber;
using nlohmann::json;

constexpr std::size_t kMaxSubscriptions = 64;
constexpr std::uint8_t kMessageData = 1;  // opcode
constexpr int kStatusWarning = 1;

json Advertisement() {
  json channels = json::array();
  for (std::size_t id = 0; id < FoxgloveTopics().size(); ++id) {
    const FoxgloveTopic& topic = FoxgloveTopics()[id];
    channels.push_back({{"id", id},
                        {"topic", topic.name},
                        {"encoding", "json"},
                        {"schemaName", topic.schema_name},
                        {"schemaEncoding", "jsonschema"},
                        {"schema", topic.schema}});
  }
  return {{"op", "advertise"}, {"channels", std::move(channels)}};
}

}  // namespace

FoxgloveConversation::FoxgloveConversation(Peer* peer, ViewHub* hub) : peer_(peer), hub_(hub) {
  hub_->Add(this);
  const json info = {{"op", "serverInfo"},
                     {"name", "gmapping_spa: " + hub_->first_run().title().name},
                     {"capabilities", json::array()},
                     {"supportedEncodings", {"json"}},
                     {"metadata", json::object()}};
  peer_->Send(TextMessage(info.dump(-1, ' ', false, json::error_handler_t::replace)));
  peer_->Send(TextMessage(Advertisement().dump()));
}

FoxgloveConversation::~FoxgloveConversation() { hub_->Remove(this); }

void FoxgloveConversation::Complain(const char* text) {
  const json status = {{"op", "status"}, {"level", kStatusWarning}, {"message", text}};
  peer_->Send(TextMessage(status.dump()));
}

void FoxgloveConversation::OnMessage(std::string_view data, bool is_binary) {
  const json message = ParseClientMessage(data, is_binary);
  if (message["op"] == "subscribe") {
    Subscribe(message);
  } else if (message["op"] == "unsubscribe") {
    Unsubscribe(message);
  } else {
    Complain("only subscribe and unsubscribe are understood");
  }
}

void FoxgloveConversation::Subscribe(const json& message) {
  for (const json& wish : message.at("subscriptions")) {
    const auto id = wish.at("id").get<std::uint32_t>();
    const auto channel = wish.at("channelId").get<std::size_t>();
    if (channel >= FoxgloveTopics().size() || subscriptions_.size() >= kMaxSubscriptions) {
      Complain("no such channel, or too many subscriptions");
    } else {
      subscriptions_[id] = {.channel = channel, .sent = {}};
    }
  }
  TellNews();
}

void FoxgloveConversation::Unsubscribe(const json& message) {
  for (const json& id : message.at("subscriptionIds")) {
    subscriptions_.erase(id.get<std::uint32_t>());
  }
}

void FoxgloveConversation::TellNews() {
  for (auto& [id, subscription] : subscriptions_) {
    if (peer_->IsBehind()) return;
    Send(id, &subscription);
  }
}

void FoxgloveConversation::Send(std::uint32_t id, Subscription* subscription) {
  const FoxgloveTopic& topic = FoxgloveTopics()[subscription->channel];
  const RunState& run = hub_->first_run();
  const int revision = run.revisions().*topic.revision;
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> since = now - subscription->sent;
  const bool is_final = run.latest().phase == Phase::kFinished;
  if (revision == subscription->revision) return;
  if (since.count() < topic.least_period_s && !is_final) return;
  subscription->revision = revision;
  subscription->sent = now;
  std::string bytes;
  AppendNumber(kMessageData, &bytes);
  AppendNumber(id, &bytes);
  AppendNumber(Nanoseconds(run.latest().figures.stamp_s), &bytes);
  bytes += topic.message(run).dump(-1, ' ', false, json::error_handler_t::replace);
  peer_->Send(BinaryMessage(std::move(bytes)));
}

}  // namespace gmapping_spa::view
