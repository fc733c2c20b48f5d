#include <gtest/gtest.h>

#include "protocol/bytes.h"

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/net/support/hex.h"
#include "tests/protocol/documented_bytes.h"
#include "tests/protocol/sample_messages.h"
#include "tests/support/files.h"

namespace platon::golden_bytes_test {
namespace {

// The messages that the page explains byte by byte.
const Hello kHello{kRulesVersion, "Ann"};
const Notice kNotice{"Restart at noon"};
const Vote kVote{3, true};
const VoteCount kVoteCount{3, 2, 5};
const LocalChat kChat{0, {"", 2}};
const Companion kCompanion{1, true, "Ben"};
const LocalSlots kLocalSlots{{3, 5}};
const PlayerChat kPlayerChat{5, {"Wait!", 0}};
const RoundTrips kRoundTrips{{11, 0, 1, 255}};
const RoundEnd kRoundEnd{3, 1800, 0x0123456789abcdef, "Corners", 300, LevelBest{743, "Ann", true}};
const PlayerInputs kInputs{3,
                           1,
                           300,
                           0x89abcdef,
                           302,
                           {pressing(2), pressing(2), pressing(6), pressing(0), pressing(0), pressing(0), pressing(0),
                            pressing(0), pressing(0), pressing(0), pressing(0), pressing(0)},
                           18};
const PlayerInputs kInputsOfTwo{3, 1, 300, 0x89abcdef, 302, {pressing(2), pressing(2)}, 18, {{1, 303, {pressing(1)}}}};
const ConfirmedTicks kTicks{3,
                            300,
                            8,
                            0x89abcdef,
                            LinkReport{17, 5, SlackReport{313, 4}},
                            {{300, 0, pressing(2)}, {300, 5, Input{}}, {307, 0, pressing(6)}},
                            96};

TEST(GoldenBytes, TheDocumentedBytesAreThoseOfTheEncoder) {
  const auto page = documentedBytes();
  const std::pair<const char*, Bytes> sent[] = {{"hello", encode(kHello)},
                                                {"vote", encode(kVote)},
                                                {"notice", encode(kNotice)},
                                                {"vote-count", encode(kVoteCount)},
                                                {"round-end", encode(kRoundEnd)},
                                                {"inputs", encode(kInputs)},
                                                {"ticks", encode(kTicks)},
                                                {"chat", encode(kChat)},
                                                {"player-chat", encode(kPlayerChat)},
                                                {"round-trips", encode(kRoundTrips)},
                                                {"companion", encode(kCompanion)},
                                                {"local-slots", encode(kLocalSlots)},
                                                {"inputs-of-two", encode(kInputsOfTwo)}};
  for (const auto& [name, bytes] : sent) {
    ASSERT_TRUE(page.contains(name)) << name;
    EXPECT_EQ(page.at(name), bytes) << name << ": real bytes " << toHex(bytes);
  }
}

/// The tables of the union of a schema.
std::vector<std::string> tablesOf(const std::string& schema) {
  const std::string text = readText(schema);
  const std::size_t begin = text.find('{', text.find("union ")) + 1;
  std::istringstream names(text.substr(begin, text.find('}', begin) - begin));
  std::vector<std::string> tables;
  for (std::string name; names >> name;) tables.push_back(name.substr(0, name.find(',')));
  return tables;
}

TEST(GoldenBytes, ThePageHasARowForEveryReliableMessage) {
  const std::string page = readText("docs/protocol.md");
  for (const char* schema : {"protocol/to_server.fbs", "protocol/to_client.fbs"}) {
    const std::vector<std::string> tables = tablesOf(schema);
    EXPECT_GE(tables.size(), 3u);
    for (const std::string& table : tables) {
      EXPECT_NE(page.find("\n| `" + table + "` | "), std::string::npos) << table;
    }
  }
}

TEST(GoldenBytes, TheDocumentedBytesAreDecoded) {
  const auto page = documentedBytes();
  for (const char* name : {"inputs", "ticks", "hello", "notice", "vote", "vote-count", "round-end", "chat",
                           "player-chat", "round-trips", "companion", "local-slots", "inputs-of-two"}) {
    ASSERT_TRUE(page.contains(name)) << name;
  }
  EXPECT_EQ(decodeToServer(page.at("inputs")), ToServer(kInputs));
  EXPECT_EQ(decodeToServer(page.at("inputs-of-two")), ToServer(kInputsOfTwo));
  EXPECT_EQ(decodeToServer(page.at("hello")), ToServer(kHello));
  EXPECT_EQ(decodeToServer(page.at("companion")), ToServer(kCompanion));
  EXPECT_EQ(decodeToClient(page.at("local-slots")), ToClient(kLocalSlots));
  EXPECT_EQ(decodeToClient(page.at("notice")), ToClient(kNotice));
  EXPECT_EQ(decodeToServer(page.at("vote")), ToServer(kVote));
  EXPECT_EQ(decodeToServer(page.at("chat")), ToServer(kChat));
  EXPECT_EQ(decodeToClient(page.at("player-chat")), ToClient(kPlayerChat));
  EXPECT_EQ(decodeToClient(page.at("vote-count")), ToClient(kVoteCount));
  EXPECT_EQ(decodeToClient(page.at("round-end")), ToClient(kRoundEnd));
  EXPECT_EQ(decodeToClient(page.at("ticks")), ToClient(kTicks));
}

}  // namespace
}  // namespace platon::golden_bytes_test
