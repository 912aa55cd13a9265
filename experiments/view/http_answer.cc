// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/http_answer.h"

#include <algorithm>
#include <boost/beast/http/field.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/http/status.hpp>
#include <boost/beast/http/verb.hpp>
#include <string_view>

#include "experiments/view/request_check.h"

namespace gmapping_spa::view {
namespace {

namespace http = boost::beast::http;
using http::field;
using http::status;

std::string_view HeaderOf(const HttpRequest& request, field name) {
  const boost::beast::string_view value = request[name];
  return {value.data(), value.size()};
}

HttpAnswer PlainAnswerTo(const HttpRequest& request, status status, const std::string& text) {
  return PlainAnswer(status, request.version(), request.keep_alive(), text);
}

bool MayRead(std::string_view origin, const ServerOptions& options) {
  return std::find(options.reading_origins.begin(), options.reading_origins.end(), origin) !=
         options.reading_origins.end();
}

}  // namespace

HttpAnswer PlainAnswer(status status, unsigned version, bool keep_alive, const std::string& text) {
  HttpAnswer answer(status, version);
  answer.set(field::content_type, "text/plain; charset=utf-8");
  answer.set(field::cache_control, "no-cache");
  answer.set("Content-Security-Policy",
             "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; "
             "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
  answer.set("X-Content-Type-Options", "nosniff");
  answer.set("Cross-Origin-Resource-Policy", "same-origin");
  answer.set("Referrer-Policy", "no-referrer");
  answer.keep_alive(keep_alive);
  answer.body() = text;
  answer.prepare_payload();
  return answer;
}

std::optional<HttpAnswer> Refusal(const HttpRequest& request, const Connections& connections) {
  if (IsOwnHost(HeaderOf(request, field::host), connections.options.address)) return std::nullopt;
  return PlainAnswer(status::misdirected_request, request.version(), false,
                     "expected a Host that is this machine, by its address or as localhost\n");
}

HttpAnswer FileAnswer(const HttpRequest& request, const std::vector<StaticFile>& files) {
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    HttpAnswer answer = PlainAnswerTo(request, status::method_not_allowed, "expected GET\n");
    answer.set(field::allow, "GET, HEAD");
    return answer;
  }
  const std::string_view target(request.target().data(), request.target().size());
  const std::string_view path = target.substr(0, target.find('?'));
  const auto file =
      std::find_if(files.begin(), files.end(), [&](const StaticFile& f) { return f.path == path; });
  if (file == files.end()) return PlainAnswerTo(request, status::not_found, "no such file\n");
  HttpAnswer answer = PlainAnswerTo(request, status::ok, std::string(file->content));
  answer.set(field::content_type,
             boost::beast::string_view(file->content_type.data(), file->content_type.size()));
  if (request.method() == http::verb::head) answer.body().clear();  // the length stays
  return answer;
}

std::variant<const Protocol*, HttpAnswer> ChooseProtocol(const HttpRequest& request,
                                                         const Connections& connections) {
  const Protocol* chosen = nullptr;
  for (const auto& offered : http::token_list(request[field::sec_websocket_protocol])) {
    for (const Protocol& protocol : connections.protocols) {
      if (chosen == nullptr && offered == protocol.name) chosen = &protocol;
    }
  }
  if (chosen == nullptr) {
    return PlainAnswerTo(request, status::bad_request, "no protocol of these is spoken here\n");
  }
  // Browsers send it always, so that who does not is no page.
  const std::string_view origin = HeaderOf(request, field::origin);
  const bool may = origin.empty() || IsSameOrigin(origin, HeaderOf(request, field::host)) ||
                   (chosen->only_reads && MayRead(origin, connections.options));
  if (!may) return PlainAnswerTo(request, status::forbidden, "this origin may not connect\n");
  if (connections.clients >= connections.options.max_clients) {
    return PlainAnswerTo(request, status::service_unavailable, "too many clients\n");
  }
  return chosen;
}

}  // namespace gmapping_spa::view
