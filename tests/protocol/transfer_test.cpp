#include "protocol/transfer.h"

#include <gtest/gtest.h>

#include "protocol/bytes.h"
#include "tests/protocol/sample_messages.h"

namespace platon::transfer_test {
namespace {

TEST(Assembly, JoinsChunks) {
  Assembly assembly;
  EXPECT_FALSE(assembly.add(5, 0, Bytes{1, 2}));
  EXPECT_FALSE(assembly.add(5, 2, Bytes{3, 4}));
  EXPECT_TRUE(assembly.add(5, 4, Bytes{5}));
  EXPECT_EQ(assembly.bytes(), Bytes({1, 2, 3, 4, 5}));
}

TEST(Assembly, AChunkAtOffsetZeroStartsOver) {
  Assembly assembly;
  EXPECT_FALSE(assembly.add(5, 0, Bytes{1, 2}));
  EXPECT_FALSE(assembly.add(3, 0, Bytes{7}));
  EXPECT_TRUE(assembly.add(3, 1, Bytes{8, 9}));
  EXPECT_EQ(assembly.bytes(), Bytes({7, 8, 9}));
}

TEST(Assembly, AChunkOutOfOrderDiscardsAllChunks) {
  const auto discarded = [](std::uint32_t total, std::uint32_t offset, const Bytes& chunk) {
    Assembly assembly;
    assembly.add(4, 0, Bytes{1, 2});
    if (assembly.add(total, offset, chunk) || !assembly.bytes().empty()) return false;
    return !assembly.add(4, 2, Bytes{3, 4}) && assembly.bytes().empty();
  };
  EXPECT_TRUE(discarded(4, 3, {4}));
  EXPECT_TRUE(discarded(4, 1, {2}));
  EXPECT_TRUE(discarded(5, 2, {3}));
  EXPECT_TRUE(discarded(4, 2, {3, 4, 5}));
  EXPECT_TRUE(discarded(4, 2, {}));
}

TEST(Assembly, RefusesAChunkAfterTheEnd) {
  Assembly assembly;
  EXPECT_TRUE(assembly.add(1, 0, Bytes{1}));
  EXPECT_FALSE(assembly.add(1, 1, Bytes{2}));
}

TEST(FullState, DecodesWhatWasEncoded) {
  const FullState empty;
  EXPECT_EQ(decodeFullState(encode(empty)), empty);
  const FullState state{{pressing(Input::kRight), Input{},
                         pressing(Input::kLeft | Input::kJump | Input::kDown | Input::kRestart | Input::kCreep)},
                        {1, 2, 3, 4}};
  EXPECT_EQ(decodeFullState(encode(state)), state);
  const FullState most{std::vector<Input>(kMaxPlayers, pressing(0)), {}};
  EXPECT_EQ(decodeFullState(encode(most)), most);
}

TEST(FullState, RefusesMalformedBytes) {
  EXPECT_FALSE(decodeFullState(Bytes{}));
  EXPECT_FALSE(decodeFullState(Bytes{2, 0x80}));
  EXPECT_FALSE(decodeFullState(Bytes{1, 0x01}));  // buttons of an absent player
  EXPECT_FALSE(decodeFullState(Bytes{1, 0x83}));  // both directions
  EXPECT_FALSE(decodeFullState(Bytes{1, 0xc0}));  // a speed without a direction
  EXPECT_FALSE(decodeFullState(encode(FullState{std::vector<Input>(kMaxPlayers + 1), {}})));
}

}  // namespace
}  // namespace platon::transfer_test
