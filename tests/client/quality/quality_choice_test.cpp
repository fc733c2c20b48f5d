#include "client/quality/quality_choice.h"

#include <sstream>

#include <gtest/gtest.h>

namespace platon::quality_choice_test {
namespace {

// The choice of these lines, of which all must be valid.
QualityChoice parsed(const std::string& text) {
  QualityChoice choice;
  std::istringstream words(text);
  for (std::string name, value; words >> name >> value;) {
    const auto parse = name == "quality" ? parseLevel : name == "render-scale" ? parseScale : parseSamples;
    EXPECT_TRUE(parse(value, choice)) << name << " " << value;
  }
  return choice;
}

TEST(QualityChoice, ParsingTheTextGivesTheSameChoice) {
  for (const QualityChoice& choice :
       {QualityChoice(), QualityChoice{QualityLevel::kLow, {}, {}}, QualityChoice{QualityLevel::kAll, 0.65, 2},
        QualityChoice{{}, 0.5, 4}, QualityChoice{QualityLevel::kMedium, 1, 1}}) {
    EXPECT_EQ(parsed(choice.text()), choice) << choice.text();
  }
  EXPECT_EQ(QualityChoice().text(), "quality auto\n");
  EXPECT_EQ((QualityChoice{QualityLevel::kAll, 0.65, 2}.text()), "quality all\nrender-scale 0.65\nmultisampling 2\n");
}

TEST(QualityChoice, BadValuesChangeNothing) {
  QualityChoice choice{QualityLevel::kLow, 0.75, 2};
  const QualityChoice before = choice;
  for (const char* value : {"", "best", "Auto"}) EXPECT_FALSE(parseLevel(value, choice)) << value;
  for (const char* value : {"", "0.49", "1.01", "nan", "0.8x", "-1"}) EXPECT_FALSE(parseScale(value, choice)) << value;
  for (const char* value : {"", "0", "3", "8", "16", "4x"}) EXPECT_FALSE(parseSamples(value, choice)) << value;
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
