// The stand-in for the sidecar of Agones takes what the description of Agones allows, and nothing else.
#include "tests/server/fleet/sidecar_request.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace platon::sidecar_request_test {
namespace {

using Body = std::map<std::string, std::string>;

SidecarRequest read(const std::string& line, const std::string& body) {
  return SidecarRequest::read(line + " HTTP/1.1\r\nContent-Type: application/json\r\n\r\n" + body);
}

std::string faultOf(const std::string& line, const std::string& body) {
  try {
    read(line, body);
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(SidecarRequestTest, ReadsMethodPathAndProperties) {
  const SidecarRequest request =
      read("PATCH /v1beta1/counters/players", R"( { "count" : "3", "capacity":"16","countDiff":"-1" } )");
  EXPECT_EQ(request.method, "PATCH");
  EXPECT_EQ(request.path, "/v1beta1/counters/players");
  EXPECT_EQ(request.body, (Body{{"count", "3"}, {"capacity", "16"}, {"countDiff", "-1"}}));
}

TEST(SidecarRequestTest, TakesTheOperationsWithoutProperties) {
  for (const char* path : {"/allocate", "/health", "/ready", "/shutdown"}) {
    EXPECT_EQ(read(std::string("POST ") + path, "{}").body, Body{});
  }
}

TEST(SidecarRequestTest, RefusesUnknownOperations) {
  EXPECT_EQ(faultOf("PUT /ready", "{}"), "there is no PUT /ready");
  EXPECT_EQ(faultOf("POST /v1/ready", "{}"), "there is no POST /v1/ready");
  EXPECT_EQ(faultOf("PATCH /v1beta1/counters/", "{}"), "there is no PATCH /v1beta1/counters/");
  EXPECT_EQ(faultOf("PATCH /v1beta1/counters/a/b", "{}"), "there is no PATCH /v1beta1/counters/a/b");
  EXPECT_EQ(faultOf("ready", "{}"), "this is no request: ready HTTP/1.1");
}

TEST(SidecarRequestTest, RefusesUnknownPropertiesAndTypes) {
  const std::string counter = "PATCH /v1beta1/counters/players";
  EXPECT_EQ(faultOf("POST /ready", R"({"count":"3"})"), "/ready has no property count");
  EXPECT_EQ(faultOf(counter, R"({"players":"3"})"), "/v1beta1/counters/{} has no property players");
  EXPECT_EQ(faultOf(counter, R"({"count":3})"), "the body is no object of strings: {\"count\":3}");
  EXPECT_EQ(faultOf(counter, R"({"count":"three"})"), "count is no number of 64 bits: three");
  EXPECT_EQ(faultOf(counter, R"({"count":"3","count":"4"})"), "the property count is there twice");
  EXPECT_EQ(faultOf(counter, R"({"count":"3",})"), "the body is no object of strings: {\"count\":\"3\",}");
  EXPECT_EQ(faultOf(counter, ""), "the body is no object of strings: ");
}

TEST(SidecarRequestTest, RefusesABodyThatIsNotDeclared) {
  EXPECT_THROW(SidecarRequest::read("POST /ready HTTP/1.1\r\nContent-Length: 2\r\n\r\n{}"), std::invalid_argument);
}

}  // namespace
}  // namespace platon::sidecar_request_test
