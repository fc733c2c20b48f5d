#include "client/menu/menu_layout.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "client/ui/overlay.h"
#include "client/ui/text_scale.h"
#include "tests/client/menu/sample_pages.h"

namespace platon {
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
  for (const MenuLine& note : layout.notes) boxes.push_back(note.box);
  for (const MenuRow& row : layout.rows) {
    boxes.push_back(row.name.box);
    if (!row.value.box.empty()) boxes.push_back(row.value.box);
    if (!row.control.empty() && !overlap(row.control, row.value.box)) boxes.push_back(row.control);
  }
  if (!layout.scrollTrack.empty()) boxes.push_back(layout.scrollTrack);
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
          page.items = itemsOfEveryKind(field, isLong);
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

}  // namespace
}  // namespace platon
