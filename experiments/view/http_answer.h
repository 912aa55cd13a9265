// SPDX-License-Identifier: BSD-3-Clause
// Answers to requests, apart from how they are sent.
#ifndef GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_ANSWER_H_
#define GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_ANSWER_H_

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "experiments/view/connections.h"

namespace gmapping_spa::view {

using HttpRequest = boost::beast::http::request<boost::beast::http::string_body>;
using HttpAnswer = boost::beast::http::response<boost::beast::http::string_body>;

// With the headers that every answer has: nothing from elsewhere runs in the page, and it is in no
// frame of another one.
HttpAnswer PlainAnswer(boost::beast::http::status status, unsigned version, bool keep_alive,
                       const std::string& text);

// Why a request is not looked at any further: its Host is not this machine.
std::optional<HttpAnswer> Refusal(const HttpRequest& request, const Connections& connections);

// The file that the request names, or why there is none.
HttpAnswer FileAnswer(const HttpRequest& request, const std::vector<StaticFile>& files);

// The first of the protocols that a WebSocket offers which this server speaks, or why it may not:
// pages of other origins only what only reads, and nobody where there are too many.
std::variant<const Protocol*, HttpAnswer> ChooseProtocol(const HttpRequest& request,
                                                         const Connections& connections);

}  // namespace gmapping_spa::view

#endif  // GMAPPING_SPA_EXPERIMENTS_VIEW_HTTP_ANSWER_H_
