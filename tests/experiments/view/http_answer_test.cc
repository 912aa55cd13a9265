// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/view/http_answer.h"

#include <gtest/gtest.h>

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/status.hpp>
#include <boost/beast/http/verb.hpp>
#include <string>

namespace gmapping_spa::view {
namespace {

namespace http = boost::beast::http;
using http::field;
using http::status;

HttpRequest Get(const char* target) {
  HttpRequest request(http::verb::get, target, 11);
  request.set(field::host, "localhost:8080");
  return request;
}

HttpRequest Upgrade(const char* protocol, const char* origin) {
  HttpRequest request = Get("/");
  request.set(field::sec_websocket_protocol, protocol);
  if (*origin != '\0') request.set(field::origin, origin);
  return request;
}

Connections TwoProtocols() {
  return {{.reading_origins = {"https://reader.example"}, .max_clients = 2},
          {{"/", "text/html", "<p>"}, {"/a.js", "text/javascript", "1"}},
          {{.name = "steer", .begin = {}}, {.name = "read", .only_reads = true, .begin = {}}}};
}

status StatusOf(const std::variant<const Protocol*, HttpAnswer>& choice) {
  const auto* answer = std::get_if<HttpAnswer>(&choice);
  return answer == nullptr ? status::switching_protocols : answer->result();
}

TEST(HttpAnswer, FilesHaveTheirTypeAndForbidWhatComesFromElsewhere) {
  const HttpAnswer answer = FileAnswer(Get("/a.js?x"), TwoProtocols().files);
  EXPECT_EQ(answer.result(), status::ok);
  EXPECT_EQ(answer[field::content_type], "text/javascript");
  EXPECT_EQ(answer.body(), "1");
  EXPECT_NE(std::string(answer["Content-Security-Policy"]).find("default-src 'none'"),
            std::string::npos);
  EXPECT_EQ(answer.count("Access-Control-Allow-Origin"), 0U);
}

TEST(HttpAnswer, OtherFilesAndMethodsAreRefused) {
  const Connections connections = TwoProtocols();
  EXPECT_EQ(FileAnswer(Get("/../etc/passwd"), connections.files).result(), status::not_found);
  HttpRequest post = Get("/");
  post.method(http::verb::post);
  EXPECT_EQ(FileAnswer(post, connections.files).result(), status::method_not_allowed);
  HttpRequest head = Get("/");
  head.method(http::verb::head);
  const HttpAnswer answer = FileAnswer(head, connections.files);
  EXPECT_EQ(answer.body(), "");
  EXPECT_EQ(answer[field::content_length], "3");
}

TEST(HttpAnswer, StrangeHostIsRefused) {
  const Connections connections = TwoProtocols();
  EXPECT_FALSE(Refusal(Get("/"), connections));
  HttpRequest request = Get("/");
  request.set(field::host, "evil.example:8080");
  EXPECT_EQ(Refusal(request, connections)->result(), status::misdirected_request);
  request.erase(field::host);
  EXPECT_TRUE(Refusal(request, connections));
}

TEST(HttpAnswer, FirstProtocolOfferedThatIsSpokenIsChosen) {
  const Connections connections = TwoProtocols();
  const auto choice = ChooseProtocol(Upgrade("other, read, steer", ""), connections);
  ASSERT_EQ(StatusOf(choice), status::switching_protocols);
  EXPECT_EQ(std::get<const Protocol*>(choice)->name, "read");
  EXPECT_EQ(StatusOf(ChooseProtocol(Upgrade("other", ""), connections)), status::bad_request);
  EXPECT_EQ(StatusOf(ChooseProtocol(Get("/"), connections)), status::bad_request);
}

TEST(HttpAnswer, PagesOfOtherOriginsReadWhereTheyMayAndNeverSteer) {
  const Connections connections = TwoProtocols();
  const auto status_of = [&](const char* protocol, const char* origin) {
    return StatusOf(ChooseProtocol(Upgrade(protocol, origin), connections));
  };
  EXPECT_EQ(status_of("steer", "http://localhost:8080"), status::switching_protocols);
  EXPECT_EQ(status_of("steer", "https://reader.example"), status::forbidden);
  EXPECT_EQ(status_of("steer", "http://localhost:8081"), status::forbidden);
  EXPECT_EQ(status_of("steer", "null"), status::forbidden);
  EXPECT_EQ(status_of("read", "https://reader.example"), status::switching_protocols);
  EXPECT_EQ(status_of("read", "https://evil.example"), status::forbidden);
}

TEST(HttpAnswer, TooManyClientsAreTurnedAway) {
  Connections connections = TwoProtocols();
  connections.clients = 2;
  EXPECT_EQ(StatusOf(ChooseProtocol(Upgrade("read", ""), connections)),
            status::service_unavailable);
}

}  // namespace
}  // namespace gmapping_spa::view
