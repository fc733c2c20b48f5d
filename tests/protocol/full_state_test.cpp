#include "protocol/full_state.h"

#include <gtest/gtest.h>

#include "protocol/bytes.h"

#include "tests/protocol/sample_messages.h"

namespace platon::full_state_test {
namespace {

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
}  // namespace platon::full_state_test
