#include "protocol/to_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <variant>

#include "protocol/input_code.h"
#include "tests/protocol/sample_messages.h"

namespace platon::to_server_test {
namespace {

TEST(ToServer, DecodesWhatWasEncoded) {
  const std::vector<ToServer> samples = sampleToServer();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(decodeToServer(encodeAny(samples[i])), samples[i]) << "sample " << i;
  }
}

// Long runs of equal inputs are written in another way than short ones.
TEST(ToServer, DecodesRunsOfAnyLength) {
  for (std::size_t length = 1; length <= kMaxInputsPerMessage; ++length) {
    PlayerInputs message{9, 1, 5, 7, 5, std::vector<Input>(length, pressing(8))};
    EXPECT_EQ(decodeToServer(encode(message)), ToServer(message)) << length;
  }
}

TEST(ToServer, EveryKindOfMessageHasASample) {
  std::set<std::size_t> kinds;
  for (const ToServer& sample : sampleToServer()) kinds.insert(sample.index());
  EXPECT_EQ(kinds.size(), std::variant_size_v<ToServer>);
}

TEST(ToServer, DecodesBytesAtAnyAddress) {
  for (const ToServer& sample : sampleToServer()) {
    std::vector<std::uint8_t> shifted = encodeAny(sample);
    shifted.insert(shifted.begin(), 0);
    EXPECT_EQ(decodeToServer(std::span(shifted).subspan(1)), sample);
  }
}

TEST(ToServer, RefusesNamesThatAreNoLabels) {
  EXPECT_FALSE(decodeToServer(encode(Hello{kRulesVersion, "a\nb"})));
  EXPECT_FALSE(decodeToServer(encode(Hello{kRulesVersion, std::string(kMaxNameBytes + 1, 'a')})));
}

TEST(ToServer, RefusesATokenOfAnotherLength) {
  std::vector<std::uint8_t> bytes = encode(Hello{kRulesVersion, "", SessionToken{7, 7}});
  const std::array<std::uint8_t, 4> length = {sizeof(SessionToken), 0, 0, 0};
  const auto token = std::search(bytes.begin(), bytes.end(), length.begin(), length.end());
  ASSERT_NE(token, bytes.end());
  ASSERT_TRUE(decodeToServer(bytes));
  *token = sizeof(SessionToken) - 1;
  EXPECT_FALSE(decodeToServer(bytes));
}

TEST(ToServer, AShortenedMessageNeverDecodesToAnotherKind) {
  for (const ToServer& sample : sampleToServer()) {
    const std::vector<std::uint8_t> whole = encodeAny(sample);
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::vector<std::uint8_t> part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      const auto decoded = decodeToServer(part);
      EXPECT_TRUE(!decoded || decoded->index() == sample.index());
    }
  }
}

TEST(ToServer, RefusesMessagesAboveTheLargestSize) {
  std::vector<std::uint8_t> bytes = encode(Leave{});
  bytes.resize(kMaxMessageBytes);
  EXPECT_TRUE(decodeToServer(bytes));
  bytes.push_back(0);
  EXPECT_FALSE(decodeToServer(bytes));
}

TEST(ToServer, RefusesInputsBeyondTheLargestTick) {
  const auto refused = [](std::size_t inputs) {
    constexpr std::uint32_t kFirst = UINT32_MAX - 3;
    return !decodeToServer(encode(PlayerInputs{3, 1, kFirst, 0, kFirst, std::vector<Input>(inputs, pressing(2))}));
  };
  EXPECT_FALSE(refused(3));
  EXPECT_TRUE(refused(4));
}

// What a companion adds to 00 03 00 01 05 00000007 00 82.
TEST(ToServer, RefusesCompanionsThatAreNone) {
  const auto decodes = [](std::vector<std::uint8_t> companions) {
    std::vector<std::uint8_t> bytes = encode(PlayerInputs{3, 1, 5, 7, 5, {pressing(2), pressing(2)}});
    bytes.insert(bytes.end(), companions.begin(), companions.end());
    return decodeToServer(bytes).has_value();
  };
  const std::uint8_t one = 1 << 6 | kAbsentCode, two = 2 << 6 | kAbsentCode, none = kAbsentCode, run = 1 << 6;
  EXPECT_TRUE(decodes({one, 0, run, two, 3, run}));
  EXPECT_FALSE(decodes({none, 0, run})) << "local number 0";
  EXPECT_FALSE(decodes({two, 0, run, one, 0, run})) << "falling";
  EXPECT_FALSE(decodes({one, 0, run, one, 0, run})) << "twice";
  EXPECT_FALSE(decodes({one, 0})) << "no input";
  EXPECT_FALSE(decodes({one})) << "no tick";
  EXPECT_FALSE(decodes({one, 0, two, 0, run})) << "no input of the first";
  EXPECT_FALSE(decodes({one, 0xff, 0xff, 0xff, 0xff, 0x0f, run})) << "beyond the last tick";
  EXPECT_FALSE(decodes({one, 0xfa, 0xff, 0xff, 0xff, 0x0f, run})) << "ends beyond it";
  EXPECT_TRUE(decodes({one, 0xf9, 0xff, 0xff, 0xff, 0x0f, run})) << "the last input that ends in time";
}

// A companion with a number that is too high is refused with a sentence by the match.
TEST(ToServer, TheFirstPlayerIsNoCompanion) {
  std::vector<std::uint8_t> bytes = encode(Companion{200, true, "Ann"});
  const auto local = std::find(bytes.begin(), bytes.end(), 200);
  ASSERT_EQ(std::count(bytes.begin(), bytes.end(), 200), 1);
  ASSERT_TRUE(decodeToServer(bytes));
  *local = 0;
  EXPECT_FALSE(decodeToServer(bytes));
  EXPECT_FALSE(decodeToServer(encode(Companion{1, true, "a\nb"})));
}

TEST(ToServer, HeldInputsTakeOneRun) {
  PlayerInputs held{3, 1, 5000, 0x01020304, 5000, std::vector<Input>(12, pressing(2))};
  EXPECT_LE(encode(held).size(), 36u);
}

}  // namespace
}  // namespace platon::to_server_test
