#include "client/ui/chat_feed.h"

#include <gtest/gtest.h>

namespace platon::chat_feed_test {
namespace {

using Lines = std::vector<std::string>;

TEST(ChatFeed, TextsAndEmotesFollowTheName) {
  ChatFeed feed;
  feed.add("Ann", "wait!", 0, 1);
  feed.add("Ben", "", 1, 2);
  EXPECT_EQ(feed.lines(3), (Lines{"Ann: wait!", "Ben waves"}));
}

TEST(ChatFeed, ALineIsShownForEightSeconds) {
  ChatFeed feed;
  feed.add("Ann", "a", 0, 1);
  feed.add("Ann", "b", 0, 5);
  EXPECT_EQ(feed.lines(8.9), (Lines{"Ann: a", "Ann: b"}));
  EXPECT_EQ(feed.lines(9), (Lines{"Ann: b"}));
  EXPECT_EQ(feed.lines(13), Lines{});
}

TEST(ChatFeed, OnlyTheNewestLinesAreShown) {
  ChatFeed feed;
  for (int i = 0; i < 9; ++i) feed.add("Ann", std::to_string(i), 0, 0);
  EXPECT_EQ(feed.lines(1), (Lines{"Ann: 4", "Ann: 5", "Ann: 6", "Ann: 7", "Ann: 8"}));
}

TEST(ChatFeed, TheNewestLinesAreKeptForWhoAnswers) {
  ChatFeed feed;
  for (int i = 0; i < 6; ++i) feed.add("Ann", std::to_string(i), 0, i);
  EXPECT_TRUE(feed.lines(100).empty());
  EXPECT_EQ(feed.newest(), (Lines{"Ann: 5", "Ann: 4", "Ann: 3", "Ann: 2", "Ann: 1"}));
}

TEST(ChatFeed, AnUnknownEmoteIsLeftOut) {
  ChatFeed feed;
  feed.add("Ann", "", 5, 0);
  EXPECT_TRUE(feed.lines(0).empty());
}

TEST(EmoteBubbles, EachPlayerShowsItsNewestEmoteForThreeSeconds) {
  EmoteBubbles bubbles;
  EXPECT_EQ(bubbles.of(0, 0), "");
  bubbles.add(0, 1, 10);
  bubbles.add(7, 4, 11);
  EXPECT_EQ(bubbles.of(0, 12.9), "Hello!");
  EXPECT_EQ(bubbles.of(7, 13.9), "Thanks!");
  EXPECT_EQ(bubbles.of(0, 13), "");
  bubbles.add(0, 1, 20);
  bubbles.add(0, 2, 21);
  EXPECT_EQ(bubbles.of(0, 23.9), "Ha ha!");
}

TEST(EmoteBubbles, ATextAndAnUnknownEmoteShowNone) {
  EmoteBubbles bubbles;
  bubbles.add(0, 0, 0);
  bubbles.add(0, 5, 0);
  EXPECT_EQ(bubbles.of(0, 0), "");
}

}  // namespace
}  // namespace platon::chat_feed_test
