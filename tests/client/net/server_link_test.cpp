#include "client/net/server_link.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "protocol/transport/server_address.h"

namespace platon::server_link_test {
namespace {

TEST(ServerLinkTest, ALinkHoldsAnAddress) {
  EXPECT_EQ(addressOfLink("platon://play.example.org:7778"), "play.example.org:7778");
  EXPECT_EQ(addressOfLink("platon://play.example.org"), "play.example.org");
  EXPECT_EQ(addressOfLink("platon://[2001:db8::1]:7778"), "[2001:db8::1]:7778");
}

TEST(ServerLinkTest, BrowsersMayAddASlashAndCapitals) {
  EXPECT_EQ(addressOfLink("platon://192.0.2.7/"), "192.0.2.7");
  EXPECT_EQ(addressOfLink("PLATON://192.0.2.7:1"), "192.0.2.7:1");
}

TEST(ServerLinkTest, OtherTextsStayAsTheyAre) {
  for (const char* const text :
       {"play.example.org:7778", "2001:db8::1", "platon", "platon:7778", "platon:/", "", "/"}) {
    EXPECT_EQ(addressOfLink(text), text);
  }
}

TEST(ServerLinkTest, ALinkWithMoreThanAnAddressIsRefused) {
  for (const std::string rest :
       {"", "/", "host/path", "host?name=x", "user@host", "host//", "host:0", "platon://host"}) {
    const std::string link = "platon://" + rest;
    EXPECT_THROW(parseServerAddress(addressOfLink(link)), std::invalid_argument) << link;
  }
}

}  // namespace
}  // namespace platon::server_link_test
