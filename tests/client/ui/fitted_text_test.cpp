#include "client/ui/fitted_text.h"

#include <gtest/gtest.h>

namespace platon::fitted_text_test {
namespace {

TEST(FittedText, WhatFitsIsUnchanged) {
  const Font font;
  EXPECT_EQ(fittedText("Resume", font, font.width("Resume")), "Resume");
  EXPECT_EQ(fittedText("", font, 0), "");
}

TEST(FittedText, WhatIsTooLongEndsWithAnEllipsisAndIsAsLongAsPossible) {
  const Font font;
  EXPECT_EQ(fittedText("Füßchen", font, font.width("Füß…")), "Füß…");
  EXPECT_EQ(fittedText("Füßchen", font, font.width("Fü…") + 0.001F), "Fü…");
  EXPECT_EQ(fittedText("Resume", font, 0.01F), "") << "not even one letter fits";
}

}  // namespace
}  // namespace platon::fitted_text_test
