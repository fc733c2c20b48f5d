#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tests/protocol/sample_messages.h"

namespace platon {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The blocks of docs/protocol.md that begin with "```bytes NAME": hexadecimal bytes, each line up to a '#'.
std::map<std::string, Bytes> documentedBytes() {
  std::ifstream page("docs/protocol.md");
  std::map<std::string, Bytes> blocks;
  std::string name;
  for (std::string line; std::getline(page, line);) {
    const std::string fence = "```";
    if (line.starts_with(fence)) {
      name = line.starts_with(fence + "bytes ") ? line.substr(fence.size() + 6) : "";
      continue;
    }
    if (name.empty()) continue;
    std::istringstream words(line.substr(0, line.find('#')));
    for (unsigned byte = 0; words >> std::hex >> byte;) blocks[name].push_back(static_cast<std::uint8_t>(byte));
  }
  return blocks;
}

// The messages that the page explains byte by byte.
const PlayerInputs kInputs{3,
                           1,
                           300,
                           0x89abcdef,
                           302,
                           {pressing(2), pressing(2), pressing(6), pressing(0), pressing(0), pressing(0), pressing(0),
                            pressing(0), pressing(0), pressing(0), pressing(0), pressing(0)},
                           18};
const ConfirmedTicks kTicks{3,
                            300,
                            8,
                            0x89abcdef,
                            LinkReport{17, 5, SlackReport{313, 4}},
                            {{300, 0, pressing(2)}, {300, 5, Input{}}, {307, 0, pressing(6)}},
                            96};

TEST(GoldenBytes, TheDocumentedBytesAreThoseOfTheEncoder) {
  const auto page = documentedBytes();
  EXPECT_EQ(page.size(), 3u);
  const std::pair<const char*, Bytes> sent[] = {
      {"hello", encode(Hello{2, 3, "Ann"})}, {"inputs", encode(kInputs)}, {"ticks", encode(kTicks)}};
  for (const auto& [name, bytes] : sent) {
    ASSERT_TRUE(page.contains(name)) << name;
    EXPECT_EQ(page.at(name), bytes) << name << ": real bytes " << testing::PrintToString(bytes);
  }
}

TEST(GoldenBytes, TheDocumentedBytesAreDecoded) {
  const auto page = documentedBytes();
  ASSERT_TRUE(page.contains("inputs") && page.contains("ticks") && page.contains("hello"));
  EXPECT_EQ(decodeToServer(page.at("inputs")), ToServer(kInputs));
  EXPECT_EQ(decodeToServer(page.at("hello")), ToServer(Hello{2, 3, "Ann"}));
  EXPECT_EQ(decodeToClient(page.at("ticks")), ToClient(kTicks));
}

}  // namespace
}  // namespace platon
