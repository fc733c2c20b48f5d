#include "client/menu/menu_painter.h"

#include "client/ui/overlay_writer.h"
#include "client/ui/text_scale.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr glm::vec4 kDim{0.02F, 0.02F, 0.05F, 0.55F};
constexpr glm::vec4 kSheet{0.07F, 0.08F, 0.13F, 0.94F};
constexpr glm::vec4 kRowColour{0.10F, 0.12F, 0.20F, 0.55F};
constexpr glm::vec4 kLoneRow{0.07F, 0.09F, 0.16F, 0.80F};  // without a sheet behind it
constexpr glm::vec4 kTrack{0.42F, 0.47F, 0.60F, 1.0F};
constexpr glm::vec4 kField{0.02F, 0.03F, 0.06F, 0.95F};
constexpr float kFocusBar = 4;

float baselineOf(const MenuLine& line) {
  return (line.box.low.y + line.box.high.y) / 2 + line.size * Font::kCapitalHeight / 2;
}

class Painter {
 public:
  Painter(const MenuPage& page, const MenuLook& look, const Font& font) : page_(&page), look_(&look), writer_(font) {}

  void paintRow(const MenuRow& row) {
    const MenuItem& item = page_->items[row.item];
    const bool focused = row.item == look_->focus;
    if (look_->aside && !focused) return;
    if (item.kind == MenuItem::Kind::kHeading) return left(row.name, kSoft);
    if (look_->aside) box(row.box, 9, kSheet);
    box(row.box, 9, focused ? kSelected : page_->large ? kLoneRow : kRowColour);
    if (focused) box({row.box.low, {row.box.low.x + kFocusBar, row.box.high.y}}, 2, kBright);
    const glm::vec4 colour = focused ? kBright : kSoft;
    left(row.name, colour);
    paintControl(item, row, focused, colour);
  }

  void paintSheet(const MenuLayout& layout, float width) {
    if (look_->aside) return;
    if (look_->dimsPicture) box({{0, 0}, glm::vec2(width, Overlay::kHeight) / look_->scale}, 0, kDim);
    if (!page_->large) box(layout.panel, 18, page_->place == MenuPage::Place::kMiddle ? kSheet : kPanel);
    if (!layout.scrollTrack.empty()) {
      box(layout.scrollTrack, 3, kRowColour);
      box(layout.scrollThumb, 3, kSoft);
    }
    left(layout.title, kBright);
    if (!layout.back.box.empty()) paintBackMark(layout.back);
    for (const MenuLine& note : layout.notes) left(note, page_->warning ? kWarning : kSoft);
  }

  Overlay take() { return scaledBy(writer_.take(), look_->scale); }

 private:
  void box(const MenuBox& box, float radius, glm::vec4 colour) { writer_.panel(box.low, box.high, radius, colour); }
  void left(const MenuLine& line, glm::vec4 colour) {
    writer_.left(line.text, {line.box.low.x, baselineOf(line)}, line.size, colour);
  }
  void right(const MenuLine& line, glm::vec4 colour) {
    writer_.right(line.text, {line.box.high.x, baselineOf(line)}, line.size, colour);
  }

  void paintBackMark(const MenuLine& mark) {
    box(mark.box, 9, page_->large ? kLoneRow : kRowColour);
    writer_.centred(mark.text, {(mark.box.low.x + mark.box.high.x) / 2, baselineOf(mark)}, mark.size, kSoft);
  }

  void paintControl(const MenuItem& item, const MenuRow& row, bool focused, glm::vec4 colour) {
    switch (item.kind) {
      case MenuItem::Kind::kChoice:
        return paintChoice(row, focused, colour);
      case MenuItem::Kind::kToggle:
        right(row.value, colour);
        return paintSwitch(row.control, item.part > 0.5);
      case MenuItem::Kind::kSlider:
        right(row.value, colour);
        return paintTrack(row.control, static_cast<float>(item.part));
      case MenuItem::Kind::kText:
        return paintField(row, focused);
      default:
        return right(row.value, focused ? colour : item.valueColour.value_or(colour));
    }
  }

  void paintChoice(const MenuRow& row, bool focused, glm::vec4 colour) {
    const MenuLine& value = row.value;
    writer_.centred(value.text, {(value.box.low.x + value.box.high.x) / 2, baselineOf(value)}, value.size, colour);
    const glm::vec4 arrows = focused ? kBright : kSoft;
    writer_.centred("‹", {(row.control.low.x + value.box.low.x) / 2, baselineOf(value)}, value.size, arrows);
    writer_.centred("›", {(row.control.high.x + value.box.high.x) / 2, baselineOf(value)}, value.size, arrows);
  }

  void paintSwitch(const MenuBox& control, bool on) {
    const float middle = (control.low.y + control.high.y) / 2;
    const MenuBox track{{control.low.x, middle - 10}, {control.high.x, middle + 10}};
    box(track, 10, on ? kGood : kTrack);
    const float knob = on ? track.high.x - 10 : track.low.x + 10;
    box({{knob - 8, middle - 8}, {knob + 8, middle + 8}}, 8, on ? kField : kBright);
  }

  void paintTrack(const MenuBox& control, float part) {
    const float middle = (control.low.y + control.high.y) / 2;
    const float knob = control.low.x + control.width() * part;
    box({{control.low.x, middle - 3}, {control.high.x, middle + 3}}, 3, kTrack);
    box({{control.low.x, middle - 3}, {knob, middle + 3}}, 3, kBright);
    box({{knob - 8, middle - 8}, {knob + 8, middle + 8}}, 8, kBright);
  }

  void paintField(const MenuRow& row, bool focused) {
    box(row.control, 6, kField);
    left(row.value, kBright);
    if (!focused) return;
    const float middle = (row.control.low.y + row.control.high.y) / 2;
    box({{row.caret, middle - 10}, {row.caret + 2, middle + 10}}, 0, kGold);
  }

  const MenuPage* page_;
  const MenuLook* look_;
  OverlayWriter writer_;
};

}  // namespace

Overlay paintMenu(const MenuPage& page, const MenuLayout& layout, const MenuLook& look, const Font& font, float width) {
  Painter painter(page, look, font);
  painter.paintSheet(layout, width);
  for (const MenuRow& row : layout.rows) painter.paintRow(row);
  return painter.take();
}

}  // namespace platon
