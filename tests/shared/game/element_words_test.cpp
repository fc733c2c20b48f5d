#include "shared/game/element_words.h"
#include "tests/support/sample_word.h"

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
    const ElementWord word = sampleWord(kind, 4);
    const Reading reading = read(word.text());
    ASSERT_TRUE(reading.word) << word.text();
    EXPECT_EQ(*reading.word, word);
    EXPECT_TRUE(reading.diagnostics.empty());
  }
}

TEST(ElementWordsTest, AMissingNumberIsExplained) {
  for (const ElementKind kind : kElementKinds) {
    if (numbersOf(kind) == 0) continue;
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

TEST(ElementWordsTest, ATimedSegmentIsSolidAndOpenForAtMostAMinute) {
  EXPECT_EQ(read("timed 1 3600").word, (ElementWord{ElementKind::kTimed, 1, 3600}));
  EXPECT_EQ(read("timed 3600 1").word, (ElementWord{ElementKind::kTimed, 3600, 1}));
  const auto messageOf = [](const std::string& words) {
    const Reading reading = read(words);
    EXPECT_FALSE(reading.word) << words;
    return reading.diagnostics.size() == 1 ? reading.diagnostics[0].message : std::string();
  };
  EXPECT_EQ(messageOf("timed"), "missing number after 'timed': the ticks for which it is solid");
  EXPECT_EQ(messageOf("timed 60"), "missing number after 'timed 60': the ticks for which it is open then");
  EXPECT_EQ(messageOf("timed 60 60 60"), "unexpected '60' after 'timed 60 60': remove it");
  const std::string solid = "the ticks for which it is solid must be a whole number between 1 and 3600, not ";
  const std::string open = "the ticks for which it is open then must be a whole number between 1 and 3600, not ";
  EXPECT_EQ(messageOf("timed 0 60"), solid + "'0'");
  EXPECT_EQ(messageOf("timed 60 0"), open + "'0'");
  EXPECT_EQ(messageOf("timed 3601 60"), solid + "'3601'");
  EXPECT_EQ(messageOf("timed 60 -1"), open + "'-1'");
  EXPECT_EQ(messageOf("timed 1.5 60"), solid + "'1.5'");
  EXPECT_EQ(messageOf("timed 60 99999999999999999999"), open + "'99999999999999999999'");
}

TEST(ElementWordsTest, AMessageRepeatsNoBytesThatAreNoCharacters) {
  const Reading reading = read("key \xff 3");
  ASSERT_EQ(reading.diagnostics.size(), 1u);
  EXPECT_EQ(reading.diagnostics[0].message, "unexpected '3' after 'key ?': remove it");
}

TEST(ElementWordsTest, AHintNamesTheNearestWordIfItIsNear) {
  for (const auto& [typed, meant] : {std::pair("onewy", "oneway"),
                                     {"chekpoint", "checkpoint"},
                                     {"dor", "door"},
                                     {"palte", "plate"},
                                     {"keys", "key"},
                                     {"timer", "timed"}}) {
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
