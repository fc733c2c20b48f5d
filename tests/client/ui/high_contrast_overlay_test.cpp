#include "client/ui/high_contrast_overlay.h"

#include <gtest/gtest.h>
#include <glm/vec3.hpp>

#include "client/ui/overlay_writer.h"

namespace platon::high_contrast_overlay_test {
namespace {

using namespace overlay_colours;

TEST(HighContrastOverlay, PanelsAreOpaqueAndDarkOnesBlack) {
  Overlay overlay;
  for (const glm::vec4 colour : {kPanel, kSelected}) overlay.panels.push_back({{10, 10}, {90, 40}, 5, colour});
  raiseContrast(overlay);
  EXPECT_EQ(overlay.panels[0].colour, glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(overlay.panels[1].colour, glm::vec4(glm::vec3(kSelected), 1));
}

TEST(HighContrastOverlay, WhatDimsTheWholePictureStillDoes) {
  Overlay overlay;
  overlay.panels.push_back({{0, 0}, {1280, Overlay::kHeight}, 0, {0, 0, 0, 0.5F}});
  const glm::vec4 before = overlay.panels[0].colour;
  raiseContrast(overlay);
  EXPECT_EQ(overlay.panels[0].colour, before);
}

TEST(HighContrastOverlay, TextsAreAsBrightAsTheyCanBe) {
  Overlay overlay;
  for (const glm::vec4 colour : {kSoft, kWarning, glm::vec4(0.05F, 0.05F, 0.08F, 1)})
    overlay.texts.push_back({{0, 0}, 16, colour, "text"});
  raiseContrast(overlay);
  EXPECT_EQ(overlay.texts[0].colour.b, 1);
  EXPECT_GT(overlay.texts[0].colour.r, kSoft.r);
  EXPECT_EQ(overlay.texts[1].colour, kWarning);
  EXPECT_EQ(overlay.texts[2].colour.r, 0.05F) << "dark text on a bright panel";
}

}  // namespace
}  // namespace platon::high_contrast_overlay_test
