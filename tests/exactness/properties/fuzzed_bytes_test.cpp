// Runs the targets of the fuzzers on seeded random bytes.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "platon/game/level.h"
#include "tests/exactness/properties/seeded_cases.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_scene.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/files.h"
#include "tests/support/run/repetitions.h"

namespace platon::properties::fuzzed_bytes_test {
namespace {

using oracle::RandomSource;
using ByteString = std::vector<std::uint8_t>;

// Uniform bytes, or small ones with many zeros, which give small distances and repeated choices.
ByteString anyBytes(RandomSource& random, std::int64_t longest) {
  ByteString bytes(static_cast<std::size_t>(random.between(1, longest)));
  const std::int64_t limit = std::array{255, 255, 15, 3}[random.below(4)];
  const std::int64_t zeros = random.between(2, 20);
  for (std::uint8_t& byte : bytes)
    byte = random.oneIn(zeros) ? std::uint8_t{0} : static_cast<std::uint8_t>(random.between(0, limit));
  return bytes;
}

// True if the bytes give a scene, with at least 16 bytes left for entities and ticks.
bool givesAScene(const ByteString& bytes, bool& onSolid) {
  fuzz::ByteSource source(bytes);
  const auto scene = fuzz::makeFuzzScene(source);
  onSolid = scene && scene->solid;
  return scene && source.remaining().size() > 16;
}

TEST(FuzzedBytesTest, InvariantsHoldInEveryScene) {
  const std::int64_t cases = repetitions(20000);
  std::int64_t planes = 0;
  std::int64_t solids = 0;
  forEachCase(cases, [&](RandomSource& random) {
    const ByteString bytes = anyBytes(random, 600);
    EXPECT_EQ(fuzz::sceneFault(bytes), "");
    bool onSolid = false;
    if (givesAScene(bytes, onSolid)) ++(onSolid ? solids : planes);
  });
  RecordProperty("planes", std::to_string(planes));
  RecordProperty("solids", std::to_string(solids));
  EXPECT_GE(planes, cases / 8);
  EXPECT_GE(solids, cases / 8);
}

TEST(FuzzedBytesTest, EverySweepIsExact) {
  forEachCase(repetitions(60000), [](RandomSource& random) { EXPECT_EQ(fuzz::sweepFault(anyBytes(random, 200)), ""); });
}

TEST(FuzzedBytesTest, EveryMessageAndSavedGameIsReadOrRefused) {
  forEachCase(repetitions(4000), [](RandomSource& random) {
    const ByteString bytes = anyBytes(random, 400);
    EXPECT_EQ(fuzz::protocolFault(bytes), "");
    EXPECT_EQ(fuzz::gameStateFault(bytes), "");
  });
}

// Mostly replaces one digit by another, so that many texts remain valid levels.
void edit(std::string& text, RandomSource& random) {
  constexpr std::string_view letters = "0123456789 -.\n%#AEH";
  const std::size_t at = random.below(text.size());
  const bool digit = text[at] >= '0' && text[at] <= '9';
  if (digit && !random.oneIn(8)) {
    text[at] = letters[random.below(10)];
  } else if (random.oneIn(4)) {
    text.erase(at, random.below(6));
  } else if (random.oneIn(8)) {
    text[at] = letters[random.below(letters.size())];
  }
}

TEST(FuzzedBytesTest, EveryLevelIsReadOrRefused) {
  std::vector<std::string> levels;
  for (const std::string& file : solidLevels()) levels.push_back(readText(file));
  ASSERT_GE(levels.size(), 5u);
  const std::int64_t cases = repetitions(1500);
  std::int64_t accepted = 0;
  forEachCase(cases, [&](RandomSource& random) {
    std::string text = levels[random.below(levels.size())];
    for (std::int64_t edits = random.between(1, 12); edits > 0 && !text.empty(); --edits) edit(text, random);
    accepted += loadLevel(text).level ? 1 : 0;
    EXPECT_EQ(fuzz::levelFault(ByteString(text.begin(), text.end())), "");
  });
  RecordProperty("accepted", std::to_string(accepted));
  EXPECT_GE(accepted, cases / 10);
  EXPECT_LE(accepted, cases * 9 / 10);
}

}  // namespace
}  // namespace platon::properties::fuzzed_bytes_test
