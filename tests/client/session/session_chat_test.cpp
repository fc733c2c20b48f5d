// What players say to each other.
#include "client/session/session.h"

#include <gtest/gtest.h>

#include "platon/game/game.h"

namespace platon::session_chat_test {
namespace {

using std::chrono::seconds;

/// A session that the server has accepted, without a network.
class SessionChat : public testing::Test {
 protected:
  SessionChat() {
    receive(Welcome{3, 1, 17, 16, kTicksPerSecond, "Test"});
    session_.takeOutgoing();
  }

  void receive(const auto& message) { session_.receive(encode(message), Moment(0)); }
  std::vector<Chat> sent() {
    std::vector<Chat> found;
    for (const OutgoingMessage& message : session_.takeOutgoing()) {
      EXPECT_TRUE(message.reliable);
      const auto decoded = decodeToServer(message.bytes);
      if (decoded && std::holds_alternative<Chat>(*decoded)) found.push_back(std::get<Chat>(*decoded));
    }
    return found;
  }

  Session session_{"Ann", Moment(0)};
};

TEST_F(SessionChat, ATextAndAnEmoteAreSent) {
  EXPECT_TRUE(session_.say({"Hello", 0}, Moment(0)));
  EXPECT_TRUE(session_.say({"", 2}, Moment(0)));
  EXPECT_EQ(sent(), (std::vector<Chat>{{"Hello", 0}, {"", 2}}));
}

TEST_F(SessionChat, WhatTheServerWouldDropIsNotSent) {
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(session_.say({"a", 0}, Moment(0)));
  EXPECT_FALSE(session_.say({"b", 0}, seconds(1)));
  EXPECT_TRUE(session_.say({"c", 0}, seconds(2)));
  EXPECT_EQ(sent().size(), 5U);
}

TEST_F(SessionChat, NothingIsSentBeforeWelcomeAndAfterTheEnd) {
  Session early("Ben", Moment(0));
  EXPECT_FALSE(early.say({"a", 0}, Moment(0)));
  receive(Bye{ByeCode::kServerStops, ""});
  EXPECT_FALSE(session_.say({"a", 0}, Moment(0)));
}

TEST_F(SessionChat, WhatPlayersSayIsTakenOnce) {
  receive(PlayerChat{3, {"mine", 0}});
  receive(PlayerChat{5, {"", 1}});
  EXPECT_EQ(session_.takeChats(), (std::vector<PlayerChat>{{3, {"mine", 0}}, {5, {"", 1}}}));
  EXPECT_TRUE(session_.takeChats().empty());
}

TEST_F(SessionChat, OnlyTheVisiblePartIsKept) {
  receive(PlayerChat{5, {"a \u200b b", 0}});
  receive(PlayerChat{5, {"\u200b", 0}});
  EXPECT_EQ(session_.takeChats(), (std::vector<PlayerChat>{{5, {"a b", 0}}}));
}

TEST_F(SessionChat, AFloodDropsTheOldest) {
  for (std::size_t i = 0; i < Session::kMaxChats + 10; ++i) receive(PlayerChat{5, {std::to_string(i), 0}});
  const std::vector<PlayerChat> kept = session_.takeChats();
  ASSERT_EQ(kept.size(), Session::kMaxChats);
  EXPECT_EQ(kept.front().chat.text, "10");
}

}  // namespace
}  // namespace platon::session_chat_test
