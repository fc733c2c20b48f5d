#include "client/menu/menu_painter.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/client/menu/sample_pages.h"
#include "tests/client/ui/overlay_contrast.h"

namespace platon::menu_painter_test {
namespace {

class MenuPainter : public testing::Test {
 protected:
  MenuPainter() {
    field_.setText("text");
    page_.items = itemsOfEveryKind(field_, false);
    page_.notes = {"A note."};
  }

  Overlay paint(const MenuLook& look) const {
    const glm::vec2 screen = glm::vec2(1280, 720) / look.scale;
    return paintMenu(page_, layOut(page_, font_, screen, {0, look.focus}), look, font_, 1280);
  }

  Font font_;
  TextField field_{64};
  MenuPage page_{"Title"};
};

std::size_t count(const Overlay& overlay, const std::string& content) {
  return static_cast<std::size_t>(std::count_if(overlay.texts.begin(), overlay.texts.end(),
                                                [&](const Overlay::Text& text) { return text.content == content; }));
}

TEST_F(MenuPainter, ShowsEveryText) {
  const Overlay overlay = paint({1});
  EXPECT_EQ(count(overlay, "Title"), 1U);
  EXPECT_EQ(count(overlay, "A note."), 1U);
  EXPECT_EQ(count(overlay, "name"), 9U) << "seven names and two values";
  EXPECT_EQ(count(overlay, "text"), 1U);
}

TEST_F(MenuPainter, TheFocusHasAFormOfItsOwn) {
  for (std::size_t focus = 1; focus < page_.items.size(); ++focus) {
    const Overlay with = paint({focus});
    const Overlay without = paint({0});  // on the heading, which looks the same with the focus
    EXPECT_GT(with.panels.size(), without.panels.size()) << focus;
  }
}

TEST_F(MenuPainter, AMenuThatStandsAsideShowsOneItemAndDimsNothing) {
  const Overlay overlay = paint({5, true, true});
  EXPECT_EQ(count(overlay, "Title"), 0U);
  EXPECT_EQ(count(overlay, "name"), 1U);
  for (const Overlay::Panel& panel : overlay.panels) EXPECT_LT(panel.high.y - panel.low.y, 50);
}

// A picture behind the menu may be white.
TEST_F(MenuPainter, TextsStandOutFromTheirGround) {
  for (const bool large : {false, true}) {
    page_.large = large;
    for (const auto place : {MenuPage::Place::kMiddle, MenuPage::Place::kLeft}) {
      page_.place = place;
      for (std::size_t focus = 0; focus < page_.items.size(); ++focus) {
        const Overlay overlay = paint({focus});
        for (const Overlay::Text& text : overlay.texts) {
          if (text.content.empty()) continue;
          const glm::vec3 ground = groundOf(overlay, text, font_, glm::vec3(1));
          if (large && ground == glm::vec3(1)) continue;  // the title: large, with a dark seam
          EXPECT_GE(contrast(glm::vec3(text.colour), ground), 4.5F) << text.content << ", focus " << focus;
        }
      }
    }
  }
}

TEST_F(MenuPainter, TheScaleEnlargesAllAndStaysOnTheScreen) {
  const Overlay overlay = paint({1, false, true, 1.5F});
  for (const Overlay::Panel& panel : overlay.panels) {
    EXPECT_LE(panel.high.x, 1280.01F);
    EXPECT_LE(panel.high.y, 720.01F);
  }
  EXPECT_FLOAT_EQ(overlay.texts.front().size, 26 * 1.5F);
}

}  // namespace
}  // namespace platon::menu_painter_test
