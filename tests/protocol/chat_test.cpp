#include "protocol/chat.h"

#include <gtest/gtest.h>

#include "protocol/to_client.h"
#include "protocol/to_server.h"

namespace platon::chat_test {
namespace {

TEST(Chat, IsATextOrAnEmoteAndNotBoth) {
  EXPECT_TRUE(isChat({"a", 0}));
  EXPECT_TRUE(isChat({"", 1}));
  EXPECT_TRUE(isChat({"", kEmotes}));
  EXPECT_FALSE(isChat({"", 0}));
  EXPECT_FALSE(isChat({"a", 1}));
  EXPECT_FALSE(isChat({"", kEmotes + 1}));
}

TEST(Chat, ATextIsALabelOfLimitedLength) {
  EXPECT_TRUE(isChat({std::string(kMaxChatBytes, 'a'), 0}));
  EXPECT_FALSE(isChat({std::string(kMaxChatBytes + 1, 'a'), 0}));
  EXPECT_FALSE(isChat({"a\nb", 0}));
  EXPECT_FALSE(isChat({"a\x1b[2J", 0}));
  EXPECT_FALSE(isChat({"\xff", 0}));
}

// The encoders assert the limits, so the text of a valid message is replaced by one of the same length.
template <class Message>
std::vector<std::uint8_t> withLineBreak(const Message& message) {
  std::vector<std::uint8_t> bytes = encode(message);
  const auto found = std::find(bytes.begin(), bytes.end(), '~');
  EXPECT_NE(found, bytes.end());
  *found = '\n';
  return bytes;
}

TEST(Chat, ATextThatIsNoLabelIsRefusedInBothDirections) {
  EXPECT_FALSE(decodeToServer(withLineBreak(LocalChat{0, {"a~b", 0}})));
  EXPECT_FALSE(decodeToClient(withLineBreak(PlayerChat{1, {"a~b", 0}})));
}

TEST(Chat, ASlotBeyondThePlayersIsRefused) {
  EXPECT_TRUE(decodeToClient(encode(PlayerChat{kMaxPlayers - 1, {"a", 0}})));
  EXPECT_FALSE(decodeToClient(encode(PlayerChat{kMaxPlayers, {"a", 0}})));
}

}  // namespace
}  // namespace platon::chat_test
