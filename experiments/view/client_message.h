// SPDX-License-Identifier: BSD-3-Clause
// What clients send.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_CLIENT_MESSAGE_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_CLIENT_MESSAGE_H_

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace gmapping_spa::view {

// A JSON object with a text "op"; throws std::runtime_error on anything else.
inline nlohmann::json ParseClientMessage(std::string_view data, bool is_binary) {
  nlohmann::json message;
  if (!is_binary) message = nlohmann::json::parse(data, nullptr, /*allow_exceptions=*/false);
  if (!message.is_object() || !message.contains("op") || !message["op"].is_string()) {
    throw std::runtime_error("expected a JSON object with an op");
  }
  return message;
}

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_CLIENT_MESSAGE_H_
