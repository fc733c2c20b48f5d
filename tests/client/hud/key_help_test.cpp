#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/hud/hud.h"
#include "tests/client/ui/controls/random_bindings.h"

namespace platon::key_help_test {
namespace {

Overlay helpOf(const Bindings& bindings, const Font& font, bool brief = false,
               const std::vector<KeyHints>& companions = {}) {
  OverlayWriter writer(font);
  addHelp(writer, KeyHints(bindings), companions, brief);
  return writer.take();
}

bool shows(const Overlay& overlay, const std::string& content) {
  return std::any_of(overlay.texts.begin(), overlay.texts.end(),
                     [&](const Overlay::Text& text) { return text.content == content; });
}

TEST(KeyHelp, NamesTheKeysThatThePlayerHasChosen) {
  const Font font;
  EXPECT_TRUE(shows(helpOf({}, font), "Space"));
  Bindings bindings;
  bindings.bind(Control::kJump, Key::kJ);
  EXPECT_TRUE(shows(helpOf(bindings, font), "J or Space"));
}

TEST(KeyHelp, NamesTheTriggerOnlyWhereItLetsAnotherPlayerJoin) {
  const Font font;
  EXPECT_TRUE(shows(helpOf({}, font), "RT"));
  Bindings bindings;
  bindings.bind(Control::kJump, Key::kPadRightTrigger);
  const Overlay help = helpOf(bindings, font);
  EXPECT_EQ(std::count_if(help.texts.begin(), help.texts.end(), [](const auto& text) { return text.content == "RT"; }),
            1)
      << "it jumps";
}

TEST(KeyHelp, NamesTheKeysOfWhoSharesTheKeyboard) {
  const Font font;
  const KeyHints keyboard{Bindings(KeySet::kSecond)};
  const KeyHints pad(Bindings(), true);
  const auto told = [&](const std::vector<KeyHints>& companions) {
    return shows(helpOf({}, font, false, companions), "run, jump, fall, start: the other player");
  };
  EXPECT_FALSE(told({}));
  EXPECT_FALSE(told({pad})) << "the table has the buttons already";
  EXPECT_TRUE(told({pad, keyboard}));
}

TEST(KeyHelp, IsBriefWhereAllKeysHaveNoRoom) {
  const Font font;
  Bindings bindings;
  bindings.bind(Control::kJump, Key::kJ);
  const Overlay brief = helpOf(bindings, font, true);
  EXPECT_TRUE(shows(brief, "J"));
  EXPECT_TRUE(shows(brief, "← →"));
  EXPECT_TRUE(shows(brief, "pause, settings, leave"));
  EXPECT_FALSE(shows(brief, "pad A"));
  EXPECT_LT(brief.panels.front().high.x, helpOf(bindings, font).panels.front().high.x);
}

TEST(KeyHelp, StaysInsideItsPanelAndTheNarrowestPicture) {
  const Font font;
  std::mt19937_64 random(4);
  for (int i = 0; i < 50; ++i) {
    Bindings bindings;
    change(bindings, random, 30);
    const Overlay help = helpOf(bindings, font);
    const Overlay::Panel& panel = help.panels.front();
    EXPECT_GE(panel.low.y, 0);
    EXPECT_LE(panel.high.x, Overlay::kHeight * 4 / 3);
    for (const Overlay::Text& text : help.texts) {
      EXPECT_GE(text.place.x, panel.low.x);
      EXPECT_LE(text.place.x + font.width(text.content) * text.size, panel.high.x) << text.content;
    }
  }
}

}  // namespace
}  // namespace platon::key_help_test
