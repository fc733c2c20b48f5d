#include "shared/game/element_words.h"

#include <gtest/gtest.h>

#include <string>

namespace platon::element_words_test {
namespace {

struct Reading {
  std::optional<ElementWord> word;
  std::vector<Diagnostic> diagnostics;
};

// Reads the words of a line that begins with them. Faces have 5 edges.
Reading read(const std::string& words) {
  Diagnostics diagnostics;
  LevelText text(words);
  LevelLine line;
  EXPECT_TRUE(text.next(line));
  Reading reading;
  reading.word = readElementWord(line, line.tokens, 5, diagnostics);
  reading.diagnostics = diagnostics.take();
  return reading;
}

TEST(ElementWordsTest, EveryWordIsRead) {
  for (const ElementKind kind : kElementKinds) {
    const Reading reading = read(std::string(wordOf(kind)) + (hasNumber(kind) ? " 4" : ""));
    ASSERT_TRUE(reading.word) << wordOf(kind);
    EXPECT_EQ(reading.word->kind, kind);
    EXPECT_EQ(reading.word->number, hasNumber(kind) ? 4 : 0);
    EXPECT_TRUE(reading.diagnostics.empty());
  }
}

TEST(ElementWordsTest, AMissingNumberIsExplained) {
  for (const ElementKind kind : kElementKinds) {
    if (!hasNumber(kind)) continue;
    const Reading reading = read(std::string(wordOf(kind)));
    ASSERT_EQ(reading.diagnostics.size(), 1u) << wordOf(kind);
    EXPECT_NE(reading.diagnostics[0].message.back(), ' ') << reading.diagnostics[0].message;
  }
}

TEST(ElementWordsTest, TheLargestNumbersAreRead) {
  EXPECT_EQ(read("up 4").word->number, 4);
  EXPECT_FALSE(read("up 5").word);
  EXPECT_EQ(read("door 31").word->number, 31);
  EXPECT_FALSE(read("door 32").word);
}

TEST(ElementWordsTest, AHintNamesTheNearestWordIfItIsNear) {
  for (const auto& [typed, meant] : {std::pair("onewy", "oneway"),
                                     {"chekpoint", "checkpoint"},
                                     {"dor", "door"},
                                     {"palte", "plate"},
                                     {"keys", "key"}}) {
    const Reading reading = read(typed);
    ASSERT_EQ(reading.diagnostics.size(), 1u);
    EXPECT_NE(reading.diagnostics[0].message.find("did you mean '" + std::string(meant) + "'?"), std::string::npos)
        << reading.diagnostics[0].message;
  }
  for (const std::string& typed : {std::string("7"), std::string("spring"), std::string(4000, 'd')}) {
    const Reading reading = read(typed);
    ASSERT_EQ(reading.diagnostics.size(), 1u);
    EXPECT_NE(reading.diagnostics[0].message.find(": use oneway, up, "), std::string::npos);
    EXPECT_LT(reading.diagnostics[0].message.size(), 200u);
  }
}

}  // namespace
}  // namespace platon::element_words_test
