// SPDX-License-Identifier: BSD-3-Clause
// A message to clients, kept once for all of them.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_MESSAGE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_MESSAGE_H_

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gmapping_spa::view {

struct Message {
  std::string data;  // JSON, or bytes
  bool is_binary = false;
};

using MessagePtr = std::shared_ptr<const Message>;
using Messages = std::vector<MessagePtr>;

inline MessagePtr TextMessage(std::string json) {
  return std::make_shared<const Message>(Message{std::move(json), false});
}

inline MessagePtr BinaryMessage(std::string bytes) {
  return std::make_shared<const Message>(Message{std::move(bytes), true});
}

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_MESSAGE_H_
