#include "client/quality/quality_choice.h"

#include <array>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace platon::quality_choice_test {
namespace {

constexpr std::array kParts{QualityPart::kLevel, QualityPart::kScale, QualityPart::kSamples};

TEST(QualityChoice, ParsingTheTextGivesTheSameChoice) {
  for (const QualityChoice& choice :
       {QualityChoice(), QualityChoice{QualityLevel::kLow, {}, {}}, QualityChoice{QualityLevel::kAll, 0.65, 2},
        QualityChoice{{}, 0.5, 4}, QualityChoice{QualityLevel::kMedium, 1, 1}}) {
    QualityChoice parsed;
    for (const QualityPart part : kParts) {
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
}  // namespace platon::quality_choice_test
