#include "client/menu/menu_layout.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/menu/pages/failure_page.h"
#include "client/menu/pages/replays_page.h"
#include "client/menu/pages/settings_pages.h"
#include "client/menu/pages/several_players_page.h"
#include "client/ui/overlay.h"
#include "tests/client/menu/sample_pages.h"
#include "tests/client/ui/overlay_contrast.h"

namespace platon::menu_layout_test {
namespace {

const Font& font() {
  static const Font font;
  return font;
}

// 1280 × 720 and 3840 × 2160 have the same virtual screen, at scale 1, and 640 × 360 is enlarged; the others are
// narrow, wide and square.
std::vector<glm::vec2> screens() {
  std::vector<glm::vec2> all;
  for (const float aspect : {16.0F / 9, 4.0F / 3, 21.0F / 9, 1.0F, 0.56F}) {
    for (const float scale : {0.75F, 1.0F, 1.5F, 1.75F})
      all.push_back(glm::vec2(Overlay::kHeight * aspect, Overlay::kHeight) / scale);
  }
  return all;
}

bool isIn(const MenuBox& inner, const MenuBox& outer) {
  return inner.low.x >= outer.low.x && inner.low.y >= outer.low.y && inner.high.x <= outer.high.x + 0.01F &&
         inner.high.y <= outer.high.y + 0.01F && inner.low.x <= inner.high.x && inner.low.y <= inner.high.y;
}

bool overlap(const MenuBox& a, const MenuBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

// Every box of a text or a control that stands alone.
std::vector<MenuBox> boxesOf(const MenuLayout& layout) {
  std::vector<MenuBox> boxes{layout.title.box};
  if (!layout.back.box.empty()) boxes.push_back(layout.back.box);
  for (const MenuLine& note : layout.notes) boxes.push_back(note.box);
  for (const MenuRow& row : layout.rows) {
    boxes.push_back(row.name.box);
    if (!row.value.box.empty()) boxes.push_back(row.value.box);
    if (!row.control.empty() && !overlap(row.control, row.value.box)) boxes.push_back(row.control);
  }
  if (!layout.scrollTrack.empty()) boxes.push_back(layout.scrollTrack);
  if (!layout.about.empty()) boxes.push_back(layout.about);
  return boxes;
}

void expectInOrder(const MenuPage& page, glm::vec2 screen, std::size_t focus) {
  const MenuLayout layout = layOut(page, font(), screen, {0, focus});
  const std::vector<MenuBox> boxes = boxesOf(layout);
  ASSERT_TRUE(isIn(layout.panel, {{0, 0}, screen}));
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_TRUE(isIn(boxes[i], layout.panel)) << i;
    for (std::size_t other = i + 1; other < boxes.size(); ++other)
      EXPECT_FALSE(overlap(boxes[i], boxes[other])) << i << " " << other;
  }
  const auto fits = [](const MenuLine& line) {
    return font().width(line.text) * line.size <= line.box.width() + 0.01F;
  };
  EXPECT_TRUE(fits(layout.title));
  EXPECT_TRUE(fits(layout.back));
  EXPECT_EQ(layout.back.box.empty(), !page.backMark);
  for (const MenuLine& note : layout.notes) EXPECT_TRUE(fits(note)) << note.text;
  bool focusIsVisible = false;
  for (const MenuRow& row : layout.rows) {
    EXPECT_TRUE(fits(row.name) && fits(row.value)) << row.name.text << " " << row.value.text;
    EXPECT_TRUE(isIn(row.control, row.box) || row.control.empty());
    focusIsVisible = focusIsVisible || row.item == focus;
  }
  EXPECT_TRUE(focusIsVisible);
}

TEST(MenuLayout, NothingOverlapsAndNothingIsOutsideTheScreen) {
  TextField field(200);
  for (const glm::vec2 screen : screens()) {
    for (const MenuPage::Place place : {MenuPage::Place::kMiddle, MenuPage::Place::kLeft}) {
      for (const bool isLong : {false, true}) {
        field.setText(isLong ? std::string(90, 'W') : "text");
        for (const bool large : {false, true}) {
          MenuPage page{isLong ? std::string(60, 'W') : "Title"};
          if (isLong) page.notes = {std::string(500, 'n'), "a second one " + std::string(300, 'W')};
          page.place = place;
          page.large = large;
          page.backMark = !large;
          page.items = itemsOfEveryKind(field, isLong);
          if (isLong) page.items.back().about = std::string(300, 'a');
          for (std::size_t focus = 1; focus < page.items.size(); ++focus) {
            SCOPED_TRACE(testing::Message()
                         << screen.x << " × " << screen.y << " focus " << focus << " long " << isLong);
            expectInOrder(page, screen, focus);
          }
        }
      }
    }
  }
}

// The virtual screens of pictures of 640 × 360, 1280 × 720 and 3840 × 2160 pixels.
std::vector<glm::vec2> pictures() {
  std::vector<glm::vec2> all;
  for (const std::uint32_t height : {360U, 720U, 2160U})
    all.push_back(glm::vec2(Overlay::kHeight * 16 / 9, Overlay::kHeight) / textScale(1, height));
  return all;
}

// In order at each focus; at each focus its whole name and value are shown unless `cut`.
void expectReal(const MenuPage& page, bool cut = false) {
  for (const glm::vec2 screen : pictures()) {
    for (std::size_t focus = 0; focus < page.items.size(); ++focus) {
      if (!page.items[focus].canHaveFocus()) continue;
      SCOPED_TRACE(testing::Message() << page.title << " " << screen.x << " × " << screen.y << " focus " << focus);
      expectInOrder(page, screen, focus);
      for (const MenuRow& row : layOut(page, font(), screen, {0, focus}).rows) {
        const MenuItem& item = page.items[row.item];
        EXPECT_TRUE(cut || row.name.text == item.name) << row.name.text << " of " << item.name;
        EXPECT_TRUE(cut || item.field != nullptr || row.value.text == item.value)
            << row.value.text << " of " << item.value;
      }
    }
  }
}

bool notes(const MenuPage& page, const std::string& text) {
  for (const glm::vec2 screen : pictures()) {
    std::string shown;
    for (const MenuLine& line : layOut(page, font(), screen, {0, std::nullopt}).notes) shown += line.text + " ";
    if (shown.find(text) == std::string::npos) return false;
  }
  return true;
}

TEST(MenuLayout, ThePagesOfSettingsAndKeysShowAllTheirTexts) {
  Settings settings;
  for (const bool turned : {false, true}) {
    settings.toggled = {turned, turned};
    settings.controls = turned ? ControlFrame::kScreen : ControlFrame::kPlayer;
    settings.comfort.view = turned ? CameraView::kFaceFade : CameraView::kFollow;
    for (const MenuPage::Place place : {MenuPage::Place::kMiddle, MenuPage::Place::kLeft}) {
      MenuPage page = settingsPage(settings, SubPages());
      page.place = place;
      expectReal(page);
    }
  }
  constexpr std::array kLong{Key::kBackslash, Key::kKeypad0, Key::kPageDown,
                             Key::kPageUp,    Key::kKeypad9, Key::kPadLeft};
  ControlsForm form{Control::kVote, "Backspace cannot be chosen."};
  for (std::size_t i = 0; i < kControlCount; ++i) {
    Bindings bindings;
    for (const Key key : kLong) bindings.bind(static_cast<Control>(i), key);
    expectReal(controlsPage(bindings, form));
    form = {};
  }
}

// The texts of a menu in a box, from the first line on.
std::string textIn(const MenuBox& box, const Overlay& menu) {
  std::string shown;
  for (const Overlay::Text& text : menu.texts) {
    if (box.contains(text.place)) shown += (shown.empty() ? "" : " ") + text.content;
  }
  return shown;
}

TEST(MenuLayout, BelowTheSettingsStandsWhatTheOneWithTheFocusDoes) {
  Settings settings;
  const MenuPage page = settingsPage(settings, SubPages());
  for (const glm::vec2 screen : pictures()) {
    for (std::size_t focus = 0; focus < page.items.size(); ++focus) {
      if (!page.items[focus].canHaveFocus()) continue;
      const MenuLayout layout = layOut(page, font(), screen, {0, focus});
      EXPECT_FALSE(page.items[focus].about.empty()) << page.items[focus].name;
      EXPECT_EQ(textIn(layout.about, paintMenu(page, layout, {.focus = focus}, font(), screen.x)),
                page.items[focus].about)
          << "on a screen of " << screen.x << " × " << screen.y;
      for (const MenuRow& row : layout.rows) EXPECT_LE(row.box.high.y, layout.about.low.y);
    }
  }
}

TEST(MenuLayout, APageThatSaysNothingAboutItsItemsKeepsNoRoomForIt) {
  MenuPage page{"Title"};
  page.items = {{.name = "one"}, {.name = "two"}};
  const MenuLayout before = layOut(page, font(), {1280, 720}, {});
  EXPECT_TRUE(before.about.empty());
  page.items.back().about = "what it does";
  EXPECT_GT(layOut(page, font(), {1280, 720}, {}).panel.height(), before.panel.height());
}

TEST(MenuLayout, TheListsOfServersAndRunsShowTheirFacts) {
  JoinForm form;
  form.address.setText(std::string(128, 'W'));
  form.recent = {"[2001:0db8:85a3:0000:0000:8a2e:0370:7334]:65535", std::string(63, 'w') + ".example.org:65535"};
  form.found = {{std::string(32, 'W'), "192.0.2.100:65535", "192.0.2.100:65535, 256 of 256 players, 1000 ms"},
                {std::string(32, 'i'), "192.0.2.100:65535", "192.0.2.100:65535, full, needs a password"}};
  form.listFault = std::string(200, 'f');
  form.fault = "The password is wrong.";
  EXPECT_TRUE(notes(joinPage(form, [] {}), form.fault));
  expectReal(joinPage(form, [] {}), true);
  const std::vector<ReplayEntry> runs{{std::string(100, 'W'), "86400.00 s", "2026-11-23", "", true},
                                      {"Half turn", "86400.00 s", "2026-11-23", std::string(32, 'W')},
                                      {"Half turn", "", "2026-10-01", "Ben", false, "was recorded by older rules"}};
  expectReal(replaysPage(
                 runs, [](std::size_t) {}, [] {}),
             true);
}

TEST(MenuLayout, ALongPathHidesNeitherAFaultNorTheFacts) {
  const RunChoices choices{[] {}, [] {}, [] {}, [] {}};
  const ReplayEntry run{std::string(100, 'W'), "1.00 s", "2026-01-02", std::string(32, 'W')};
  const MenuPage page = runPage(run, "/" + std::string(400, 'p'), "It cannot be kept: the disk is full.", choices);
  expectReal(page, true);
  EXPECT_TRUE(notes(page, "It cannot be kept: the disk is full."));
  EXPECT_TRUE(notes(page, "1.00 s. 2026-01-02"));
}

TEST(MenuLayout, ACutReasonEndsWithDots) {
  std::string reason = "play.example.org: the list is damaged";
  for (int line = 0; line < 20; ++line) reason += "\nline " + std::to_string(line) + ": an error";
  const MenuPage page = failurePage(
      "The level is invalid", reason, [] {}, [] {});
  expectReal(page);
  for (const glm::vec2 screen : pictures()) {
    const MenuLayout layout = layOut(page, font(), screen, {});
    EXPECT_EQ(layout.notes.front().text, "play.example.org: the list is damaged");
    EXPECT_TRUE(layout.notes.back().text.ends_with(" …")) << layout.notes.back().text;
  }
  const MenuPage all = failurePage(
      "The level is invalid", "one\ntwo", [] {}, [] {});
  EXPECT_EQ(layOut(all, font(), {1280, 720}, {}).notes.back().text, "two");
}

TEST(MenuLayout, AShortPageShowsAllItsTextUncut) {
  TextField field(200);
  field.setText("text");
  MenuPage page{"Title", {"A note."}};
  page.items = itemsOfEveryKind(field, false);
  const MenuLayout layout = layOut(page, font(), {1280, 720}, {});
  ASSERT_EQ(layout.rows.size(), page.items.size());
  EXPECT_TRUE(layout.scrollTrack.empty());
  for (const MenuRow& row : layout.rows) EXPECT_EQ(row.name.text, "name");
  EXPECT_EQ(layout.rows[4].value.text, "100 %");
  EXPECT_EQ(layout.rows[6].value.text, "text");
  EXPECT_EQ(layout.notes.front().text, "A note.");
}

TEST(MenuLayout, NoTextIsSmallerThanTheSmallest) {
  TextField field(200);
  MenuPage page{"Title", {"A note."}};
  page.items = itemsOfEveryKind(field, false);
  const MenuLayout layout = layOut(page, font(), {1280, 720}, {});
  EXPECT_GE(layout.notes.front().size, kSmallestText);
  for (const MenuRow& row : layout.rows) {
    EXPECT_GE(row.name.size, kSmallestText);
    EXPECT_TRUE(row.value.box.empty() || row.value.size >= kSmallestText);
  }
}

TEST(MenuLayout, ALongListScrollsToTheFocusAndShowsItsHeading) {
  std::vector<std::size_t> chosen;
  const MenuPage page = actionPage(40, chosen);
  const MenuLayout top = layOut(page, font(), {1280, 720}, {0, 1});
  EXPECT_EQ(top.first, 0U);
  EXPECT_LT(top.rows.size(), 40U);
  EXPECT_FALSE(top.scrollTrack.empty());
  const MenuLayout end = layOut(page, font(), {1280, 720}, {0, 39});
  EXPECT_EQ(end.rows.back().item, 39U);
  EXPECT_FLOAT_EQ(end.scrollThumb.high.y, end.scrollTrack.high.y);
  EXPECT_EQ(layOut(page, font(), {1280, 720}, {30, 1}).first, 0U) << "the heading above the focus";
  EXPECT_EQ(layOut(page, font(), {1280, 720}, {99, std::nullopt}).first, 40 - top.rows.size());
}

TEST(MenuLayout, AFieldShowsWhatIsBeforeTheCaret) {
  TextField field(200);
  MenuPage page{"Title"};
  page.items = itemsOfEveryKind(field, false);
  field.setText(std::string(60, 'W') + "end");
  const MenuRow row = layOut(page, font(), {1280, 720}, {0, 6}).rows.back();
  EXPECT_EQ(row.value.text.substr(row.value.text.size() - 3), "end");
  EXPECT_NEAR(row.caret, row.value.box.low.x + font().width(row.value.text) * row.value.size, 0.01);
  page.items.back().secret = true;
  EXPECT_EQ(layOut(page, font(), {1280, 720}, {0, 6}).rows.back().value.text.find('W'), std::string::npos);
}

TEST(MenuLayout, AnEmptyFieldSaysWhatItIsForUntilSomethingIsTyped) {
  TextField field(200);
  MenuPage page{"Title"};
  page.items = {{MenuItem::Kind::kText, "Your name", "type it here"}};
  page.items.back().field = &field;
  const auto row = [&] { return layOut(page, font(), {1280, 720}, {0, 0}).rows.back(); };
  EXPECT_EQ(row().value.text, "type it here");
  EXPECT_EQ(row().caret, row().value.box.low.x) << "one types from the left";
  field.insert("A");
  EXPECT_EQ(row().value.text, "A");
}

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
}  // namespace platon::menu_layout_test
