#include "client/quality/quality.h"

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/members.h"

namespace platon::quality_test {
namespace {

PLATON_MEMBERS(Quality, samples, scale, particles, fine)
PLATON_MEMBERS(QualityChoice, level, scale, samples)

// Whether no member of the quality is less than that of the other one.
template <class... Members>
bool drawsAtLeast(const std::tuple<Members...>& more, const std::tuple<Members...>& less) {
  const auto compare = [&]<std::size_t... kIndex>(std::index_sequence<kIndex...>) {
    return ((std::get<kIndex>(more) >= std::get<kIndex>(less)) && ...);
  };
  return compare(std::index_sequence_for<Members...>());
}

TEST(Quality, EachLevelIsAtItsPlaceAndHasItsName) {
  for (std::size_t i = 0; i < kQualities.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kQualities[i].level), i);
    EXPECT_EQ(qualityLevelOf(kQualities[i].name), kQualities[i].level);
    EXPECT_EQ(&namedQuality(kQualities[i].level), &kQualities[i]);
  }
  EXPECT_EQ(qualityLevelOf(""), std::nullopt);
  EXPECT_EQ(qualityLevelOf("High"), std::nullopt);
}

TEST(Quality, EachLevelDrawsAtLeastWhatTheOneBeforeDraws) {
  for (std::size_t i = 1; i < kQualities.size(); ++i) {
    const Quality& less = kQualities[i - 1].quality;
    const Quality& more = kQualities[i].quality;
    EXPECT_TRUE(drawsAtLeast(membersOf(more), membersOf(less))) << kQualities[i].name;
    EXPECT_NE(less, more);
  }
}

TEST(Quality, EveryLevelIsDrawnAtThreeQuartersOfTheSizeOrMore) {
  for (const NamedQuality& named : kQualities) {
    EXPECT_GE(named.quality.scale, 0.75);
    EXPECT_LE(named.quality.samples, Quality::kMaxSamples);
  }
}

TEST(Quality, TheLastLevelHasEverythingOn) {
  EXPECT_EQ(kBestQuality, (Quality{4, 1, true, true}));
  const auto isOn = [](auto value) { return !std::is_same_v<decltype(value), bool> || value; };
  EXPECT_TRUE(std::apply([&](auto... values) { return (isOn(values) && ...); }, membersOf(kBestQuality)));
}

// The choice after one part got a value that is not its default.
QualityChoice chosen(QualityPart part) {
  for (const char* value : {"low", "0.75", "2"}) {
    QualityChoice choice;
    if (parse(value, part, choice)) return choice;
  }
  ADD_FAILURE() << "a part that must be " << allowedValues(part) << " takes none of the values of this test: add one";
  return {};
}

TEST(QualityChoice, EachPartIsAMemberAndChangesTheQuality) {
  std::set<std::size_t> all;
  for (const QualityPart part : kQualityParts) {
    const QualityChoice choice = chosen(part);
    const std::set<std::size_t> members = differing(membersOf(choice), membersOf(QualityChoice()));
    EXPECT_EQ(members.size(), 1U) << allowedValues(part);
    all.insert(members.begin(), members.end());
    EXPECT_NE(choice.quality(), QualityChoice().quality()) << allowedValues(part);
    EXPECT_NE(allowedValues(part), "");
  }
  EXPECT_EQ(all.size(), kQualityParts.size()) << "two parts are the same member";
  EXPECT_EQ(all.size(), std::tuple_size_v<decltype(membersOf(QualityChoice()))>) << "a member is no part";
}

TEST(QualityChoice, ParsingTheTextGivesTheSameChoice) {
  for (const QualityChoice& choice :
       {QualityChoice(), QualityChoice{QualityLevel::kLow, {}, {}}, QualityChoice{QualityLevel::kAll, 0.65, 2},
        QualityChoice{{}, 0.5, 4}, QualityChoice{QualityLevel::kMedium, 1, 1}}) {
    QualityChoice parsed;
    for (const QualityPart part : kQualityParts) {
      const std::optional<std::string> text = textOf(part, choice);
      EXPECT_TRUE(!text || parse(*text, part, parsed)) << *text;
    }
    EXPECT_EQ(parsed, choice);
  }
  EXPECT_EQ(textOf(QualityPart::kLevel, {}), "auto");
  EXPECT_EQ(textOf(QualityPart::kScale, {}), std::nullopt);
  EXPECT_EQ(textOf(QualityPart::kSamples, {}), std::nullopt);
  const QualityChoice all{QualityLevel::kAll, 0.65, 2};
  EXPECT_EQ(textOf(QualityPart::kLevel, all), "all");
  EXPECT_EQ(textOf(QualityPart::kScale, all), "0.65");
  EXPECT_EQ(textOf(QualityPart::kSamples, all), "2");
}

TEST(QualityChoice, BadValuesChangeNothing) {
  QualityChoice choice{QualityLevel::kLow, 0.75, 2};
  const QualityChoice before = choice;
  for (const char* value : {"", "best", "Auto"}) EXPECT_FALSE(parse(value, QualityPart::kLevel, choice)) << value;
  for (const char* value : {"", "0.49", "1.01", "nan", "0.8x", "-1"}) {
    EXPECT_FALSE(parse(value, QualityPart::kScale, choice)) << value;
  }
  for (const char* value : {"", "0", "3", "8", "16", "4x"}) {
    EXPECT_FALSE(parse(value, QualityPart::kSamples, choice)) << value;
  }
  EXPECT_EQ(choice, before);
}

TEST(QualityChoice, ScaleAndSamplesOverrideTheLevel) {
  EXPECT_EQ(QualityChoice().quality(), namedQuality(QualityLevel::kHigh).quality);
  EXPECT_EQ((QualityChoice{QualityLevel::kLow, {}, {}}.quality()), namedQuality(QualityLevel::kLow).quality);
  EXPECT_EQ((QualityChoice{QualityLevel::kAll, 0.5, 2}.quality()), (Quality{2, 0.5, true, true}));
}

TEST(QualityChoice, ChoosingALevelTakesItAsItIs) {
  QualityChoice choice{QualityLevel::kAll, 0.5, 2};
  choice.choose(QualityLevel::kMedium);
  EXPECT_EQ(choice.quality(), namedQuality(QualityLevel::kMedium).quality);
}

}  // namespace
}  // namespace platon::quality_test
