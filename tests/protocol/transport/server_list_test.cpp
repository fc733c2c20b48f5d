#include "protocol/transport/server_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace platon::server_list_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ServerIdentity identityOf(std::uint8_t seed) {
  CryptoKey secret{};
  secret.fill(seed);
  return ServerIdentity(secret);
}

ListedServer server(std::uint8_t seed, const std::string& address, const std::string& name = "Example") {
  return listedServer(identityOf(seed), parseServerAddress(address), name);
}

ServerList listIn(const std::string& text) {
  const auto read = readServerList(text);
  if (const auto* error = std::get_if<ParseError>(&read)) ADD_FAILURE() << error->what;
  return std::holds_alternative<ServerList>(read) ? std::get<ServerList>(read) : ServerList{};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ServerListTest, IsReadAsItWasWritten) {
  const std::vector<ListedServer> servers{server(1, "play.example.org:7777", "Example “1”"),
                                          server(2, "[2001:db8::1]:9"), server(1, "203.0.113.5", "")};
  const ServerList list = listIn(serverListText(servers));
  EXPECT_EQ(list.servers, servers);
  EXPECT_THAT(list.faults, IsEmpty());
  EXPECT_THAT(listIn(serverListText({})).servers, IsEmpty());
}

// Ed25519 is deterministic: the text of a server never changes.
TEST(ServerListTest, TheTextIsTheDocumentedOne) {
  EXPECT_EQ(serverListText({server(2, "play.example.org", "Example")}),
            "{\n"
            "  \"platonServers\": [\n"
            "    {\n"
            "      \"address\": \"play.example.org:7777\",\n"
            "      \"name\": \"Example\",\n"
            "      \"key\": \"gTl3Dqh9F19Wo1Rmw0x-zMuNipG07jeiXfYPW4_Js5Q\",\n"
            "      \"signature\": "
            "\"536h6inDrFYCpcdWbSA529t-YKoUVMImMhuO0dEj_QExrgbYqUNFIjlAefkpR7zEZTYJ7dg1xbwR_c-3_ZiWAA\"\n"
            "    }\n"
            "  ]\n"
            "}\n");
}

TEST(ServerListTest, NobodyListsAServerUnderAKeyThatItDoesNotHave) {
  const std::string text = serverListText({server(1, "a.example:1", "Ann"), server(2, "b.example:1", "Bob")});
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
           {"b.example:1", "b.example:2"}, {"b.example:1", "evil.example:1"}, {"Bob", "Rob"}}) {
    const ServerList list = listIn(replaced(text, from, to));
    ASSERT_EQ(list.servers.size(), 1u) << to;
    EXPECT_EQ(list.servers.front().name, "Ann");
    EXPECT_THAT(list.faults, ElementsAre(HasSubstr("server 2 of the list: the signature does not match the entry")));
  }
  const ListedServer first = server(1, "a.example:1", "Ann");
  const ListedServer second = server(2, "b.example:1", "Bob");
  EXPECT_THAT(listIn(replaced(text, textOf(second.key), textOf(first.key))).servers, ElementsAre(first));
  // The border between address and name is signed, too.
  EXPECT_FALSE(isSignature(first.signature, "platon server list\na.example:1A\nnn", first.key));
}

TEST(ServerListTest, LeavesOutWhatIsDamagedAndSaysWhy) {
  const std::string good = serverListText({server(1, "a.example:1")});
  for (const auto& [from, to, fault] : std::vector<std::array<std::string, 3>>{
           {"\"name\": \"Example\"", "\"name\": 3", "\"name\" must be a string"},
           {"\"name\"", "\"title\"", "\"name\" must be a string"},
           {"a.example:1", "a.example:70000", "\"address\" must be HOST:PORT"},
           {"a.example:1", "", "\"address\" must be HOST:PORT"},
           {"Example", "Ex\\nample", "\"name\" must be a text of at most 32 bytes without control characters"},
           {"\"key\": \"", "\"key\": \"x", "\"key\" is not the key of a server"}}) {
    const ServerList list = listIn(replaced(good, from, to));
    EXPECT_THAT(list.servers, IsEmpty());
    EXPECT_THAT(list.faults, ElementsAre(HasSubstr("server 1 of the list: " + fault)));
  }
  EXPECT_THAT(listIn(R"({"platonServers": [7]})").faults, ElementsAre("server 1 of the list: it must be an object"));
}

TEST(ServerListTest, TwoServersAtOneAddressAreOneTooMany) {
  const ServerList list = listIn(serverListText({server(1, "a.example:1"), server(2, "a.example:1")}));
  EXPECT_THAT(list.servers, ElementsAre(server(1, "a.example:1")));
  EXPECT_THAT(list.faults, ElementsAre("server 2 of the list: another entry has this address; remove one of the two"));
}

TEST(ServerListTest, RefusesWhatIsNoList) {
  for (const std::string& text :
       {std::string(), std::string("{}"), std::string("[]"), std::string("{\"platonServers\": {}}"),
        std::string("<html>"), std::string(kMaxServerListBytes + 1, ' '), std::string(100000, '['),
        "{\"platonServers\": [" + std::string(100000, '['), std::string("{\"platonServers\": [\"\xff\"]}")}) {
    EXPECT_TRUE(std::holds_alternative<ParseError>(readServerList(text))) << text.substr(0, 40);
  }
  std::string many = "{\"platonServers\": [0";
  for (std::size_t i = 0; i < kMaxListedServers; ++i) many += ",0";
  EXPECT_EQ(std::get<ParseError>(readServerList(many + "]}")).what, "it has more than 1000 servers; remove some");
}

TEST(ServerListTest, SkipsKeysOfLaterVersions) {
  const std::string text =
      replaced(serverListText({server(1, "a.example:1")}), "\"name\"", "\"region\": \"eu\", \"name\"");
  EXPECT_EQ(listIn(text).servers.size(), 1u);
}

std::string nested(std::size_t depth, const std::string& opening, const std::string& closing) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) text += opening;
  text += "1";
  for (std::size_t i = 0; i < depth; ++i) text += closing;
  return text;
}

// Copying or destroying a value of this depth would overflow the stack.
TEST(ServerListTest, AListThatIsNestedTooDeeplyIsRefused) {
  constexpr const char* kFault = "its arrays and objects are nested more than 8 deep; take these out";
  for (const auto& [opening, closing] : {std::pair("[", "]"), std::pair("{\"a\":", "}"), std::pair("[{\"\":", "}]")}) {
    for (const std::size_t depth : {9u, 1000u, 40'000u}) {
      const std::string value = nested(depth, opening, closing);
      for (const std::string& text : {value, "{\"platonServers\": " + value + ", \"b\": 1}",
                                      "{\"platonServers\": [{\"name\": " + value + ", \"b\": 1}]}",
                                      "{\"platonServers\": [], \"later\": " + value + "}"}) {
        const auto read = readServerList(text);
        ASSERT_TRUE(std::holds_alternative<ParseError>(read)) << text.substr(0, 40);
        EXPECT_EQ(std::get<ParseError>(read).what, kFault) << text.substr(0, 40);
      }
    }
  }
  const std::string deepest = nested(90'000, "[", "]");
  EXPECT_EQ(std::get<ParseError>(readServerList("{\"platonServers\": " + deepest + ", \"b\": 1}")).what, kFault);
}

TEST(ServerListTest, AListOfALaterVersionMayBeNestedToTheLimit) {
  const auto withDepth = [](std::size_t depth) {
    return readServerList("{\"platonServers\": [], \"later\": " + nested(depth - 1, "[", "]") + "}");
  };
  EXPECT_TRUE(std::holds_alternative<ServerList>(withDepth(8)));
  EXPECT_TRUE(std::holds_alternative<ParseError>(withDepth(9)));
}

}  // namespace
}  // namespace platon::server_list_test
