#include "client/menu/menu_layout.h"

#include <algorithm>
#include <cmath>

#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kScreenMargin = 24;  // from the edges of the screen
constexpr float kPadding = 16;
constexpr float kRowHeight = 38;
constexpr float kRowGap = 4;
constexpr float kInner = 16;  // from the ends of a row to its texts
constexpr float kNameSize = 18;
constexpr float kHeadingSize = 16;
constexpr float kNoteSize = 16;
constexpr float kNoteHeight = 22;
constexpr float kArrow = 26;  // width of the arrow of a choice
constexpr float kSwitch = 44;
constexpr float kWidestTrack = 170;
constexpr float kScrollBar = 6;
constexpr const char* kBack = "‹ Back";
constexpr float kBackSize = 16;
constexpr float kBackHeight = 30;
constexpr std::size_t kMaxNotes = 6;    // lines
constexpr std::size_t kAboutLines = 2;  // of what is said about an item
constexpr std::size_t kFewestRows = 2;

struct TitleForm {
  float size;
  float height;
};

TitleForm titleForm(const MenuPage& page, glm::vec2 screen) {
  if (!page.large) return {26, 48};
  const float size = std::clamp(screen.y * 0.13F, 40.0F, 84.0F);
  return {size, size * 1.5F};
}

MenuLine lineIn(const MenuBox& box, const std::string& text, const Font& font, float size) {
  return {box, fittedText(text, font, box.width() / size), size};
}

// Columns of a page.
MenuBox columnOf(const MenuPage& page, glm::vec2 screen) {
  const float most = screen.x - 2 * kScreenMargin;
  if (page.place == MenuPage::Place::kMiddle) {
    const float half = std::min(600.0F, most) / 2;
    return {{screen.x / 2 - half, kScreenMargin}, {screen.x / 2 + half, screen.y - kScreenMargin}};
  }
  const float left = std::min(kScreenMargin * 2, kScreenMargin + (most - std::min(most, 420.0F)) / 2);
  return {{left, kScreenMargin}, {left + std::min(std::max(420.0F, screen.x * 0.42F), most), screen.y - kScreenMargin}};
}

// At the right end of the title, which becomes shorter.
MenuLine takeBackMark(MenuBox& title, const Font& font) {
  const float width = std::ceil(font.width(kBack) * kBackSize) + kInner;
  const float middle = (title.low.y + title.high.y) / 2;
  title.high.x -= width + kInner / 2;
  return {{{title.high.x + kInner / 2, middle - kBackHeight / 2},
           {title.high.x + kInner / 2 + width, middle + kBackHeight / 2}},
          kBack,
          kBackSize};
}

std::vector<std::string> noteLines(const MenuPage& page, const Font& font, float width, float height) {
  std::vector<std::string> lines;
  for (const std::string& note : page.notes) {
    for (std::string& line : wrapText(note, font, width / kNoteSize)) lines.push_back(std::move(line));
  }
  const float needed = static_cast<float>(kFewestRows) * (kRowHeight + kRowGap);
  const auto room = static_cast<std::size_t>(std::max(0.0F, (height - needed) / kNoteHeight));
  const std::size_t shown = std::min({lines.size(), kMaxNotes, room});
  const bool cut = shown < lines.size();
  lines.resize(shown);
  if (cut && shown > 0) lines.back() += " …";
  return lines;
}

// The share of a row that its name gets, so that both texts are as long as possible.
float nameWidth(float name, float value, float inner) {
  const float room = inner - kInner;
  if (value <= 0) return inner;
  return name + value <= room ? room - value : std::min(name, std::max(room * 0.45F, room - value));
}

// Width of everything at the right of the name.
float controlWidth(const MenuItem& item, const Font& font, float inner) {
  const float text = std::ceil(font.width(item.value) * kNameSize) + 2;
  switch (item.kind) {
    case MenuItem::Kind::kChoice:
      return text + 2 * kArrow;
    case MenuItem::Kind::kToggle:
      return text + kSwitch + kInner / 2;
    case MenuItem::Kind::kSlider:
      return std::min(kWidestTrack, inner * 0.3F) + std::max(text, 76.0F);
    case MenuItem::Kind::kText:
      return inner * 0.6F;
    default:
      return item.value.empty() ? 0 : text;
  }
}

// The end of a text that is longer than its box, as far as it fits: where the player types.
void layOutField(MenuRow& row, const MenuItem& item, const Font& font) {
  std::string text = item.field->text();
  std::string before = text.substr(0, item.field->caret());
  if (item.secret) {
    const auto dots = [](const std::string& hidden) {
      std::string shown;
      for (std::size_t i = 0; i < codePointsOf(hidden).size(); ++i) shown += "•";
      return shown;
    };
    text = dots(text);
    before = dots(before);
  }
  const float room = row.value.box.width() / kNameSize;
  while (!before.empty() && font.width(before) > room) {
    const std::size_t length = (static_cast<unsigned char>(before.front()) & 0x80u) == 0 ? 1 : [&] {
      std::size_t bytes = 1;
      while (bytes < before.size() && (static_cast<unsigned char>(before[bytes]) & 0xC0u) == 0x80u) ++bytes;
      return bytes;
    }();
    before.erase(0, length);
    text.erase(0, length);
  }
  row.value.text = fittedText(item.field->text().empty() ? item.value : text, font, room);
  row.caret = row.value.box.low.x + font.width(before) * kNameSize;
}

void layOutControl(MenuRow& row, const MenuItem& item, const Font& font) {
  MenuBox& value = row.value.box;
  row.control = {{value.low.x, row.box.low.y + 5}, {value.high.x, row.box.high.y - 5}};
  switch (item.kind) {
    case MenuItem::Kind::kChoice:
      value = {{value.low.x + kArrow, value.low.y}, {value.high.x - kArrow, value.high.y}};
      break;
    case MenuItem::Kind::kToggle:
      row.control.low.x = value.high.x - kSwitch;
      value.high.x -= kSwitch + kInner / 2;
      break;
    case MenuItem::Kind::kSlider:
      row.control.high.x = value.high.x - std::max(76.0F, std::ceil(font.width(item.value) * kNameSize) + 2);
      row.control.high.x = std::max(row.control.high.x, value.low.x + 20);
      value.low.x = row.control.high.x + kInner / 2;
      break;
    case MenuItem::Kind::kText:
      value = {{value.low.x + 8, value.low.y}, {value.high.x - 8, value.high.y}};
      return layOutField(row, item, font);
    default:
      row.control = {};
      break;
  }
  row.value.text = fittedText(item.value, font, value.width() / kNameSize);
}

MenuRow rowOf(const MenuPage& page, std::size_t index, const MenuBox& box, const Font& font) {
  const MenuItem& item = page.items[index];
  MenuRow row{index, box, {}, {}};
  const MenuBox inner{{box.low.x + kInner, box.low.y}, {box.high.x - kInner, box.high.y}};
  if (item.kind == MenuItem::Kind::kHeading) {
    row.name = lineIn({{box.low.x + 2, box.low.y + 8}, {inner.high.x, box.high.y}}, item.name, font, kHeadingSize);
    return row;
  }
  const float right = controlWidth(item, font, inner.width());
  const float name = nameWidth(std::ceil(font.width(item.name) * kNameSize) + 1, right, inner.width());
  row.name = lineIn({inner.low, {inner.low.x + name, inner.high.y}}, item.name, font, kNameSize);
  if (right <= 0) return row;
  const float left = std::max(inner.low.x + name + kInner, inner.high.x - right);
  row.value = {{{left, inner.low.y}, inner.high}, "", kNameSize};
  layOutControl(row, item, font);
  return row;
}

// The heading above the focus is shown with it.
std::size_t topOf(const MenuPage& page, std::size_t focus) {
  return focus > 0 && page.items[focus - 1].kind == MenuItem::Kind::kHeading ? focus - 1 : focus;
}

std::size_t firstRow(const MenuPage& page, const MenuScroll& scroll, std::size_t visible) {
  const std::size_t first = std::min(scroll.first, page.items.size() - visible);
  if (!scroll.focus) return first;
  const std::size_t least = *scroll.focus + 1 - std::min(visible, *scroll.focus + 1);
  return std::max(std::min(first, topOf(page, *scroll.focus)), least);
}

void addScrollBar(MenuLayout& layout, std::size_t count, std::size_t visible, float top, float bottom) {
  const float right = layout.panel.high.x - kPadding / 4;
  layout.scrollTrack = {{right - kScrollBar, top}, {right, bottom}};
  const auto part = [&](std::size_t items) {
    return (bottom - top) * static_cast<float>(items) / static_cast<float>(count);
  };
  layout.scrollThumb = layout.scrollTrack;
  layout.scrollThumb.low.y = top + part(layout.first);
  layout.scrollThumb.high.y = layout.scrollThumb.low.y + part(visible);
}

// Below the rows, if an item has something to say.
float aboutHeight(const MenuPage& page) {
  const bool any =
      std::any_of(page.items.begin(), page.items.end(), [](const MenuItem& item) { return !item.about.empty(); });
  return any ? kPadding / 2 + kNoteHeight * static_cast<float>(kAboutLines) : 0;
}

constexpr glm::vec4 kDim{0.02F, 0.02F, 0.05F, 0.55F};
constexpr glm::vec4 kSheet{0.07F, 0.08F, 0.13F, 0.94F};
constexpr glm::vec4 kRowColour{0.10F, 0.12F, 0.20F, 0.55F};
constexpr glm::vec4 kLoneRow{0.07F, 0.09F, 0.16F, 0.80F};  // without a sheet behind it
constexpr glm::vec4 kTrack{0.42F, 0.47F, 0.60F, 1.0F};
constexpr glm::vec4 kPlaceholder{0.62F, 0.67F, 0.80F, 0.85F};  // of a field without text
constexpr glm::vec4 kField{0.02F, 0.03F, 0.06F, 0.95F};
constexpr float kFocusBar = 4;

float baselineOf(const MenuLine& line) {
  return (line.box.low.y + line.box.high.y) / 2 + line.size * Font::kCapitalHeight / 2;
}

class Painter {
 public:
  Painter(const MenuPage& page, const MenuLook& look, const Font& font)
      : page_(&page), look_(&look), font_(&font), writer_(font) {}

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

  void paintAbout(const MenuBox& box) {
    if (look_->aside || box.empty() || look_->focus >= page_->items.size()) return;
    std::vector<std::string> lines = wrapText(page_->items[look_->focus].about, *font_, box.width() / kNoteSize);
    if (lines.size() > kAboutLines) lines[kAboutLines - 1] += " …";
    lines.resize(std::min(lines.size(), kAboutLines));
    MenuBox place{box.low, {box.high.x, box.low.y + kNoteHeight}};
    for (const std::string& line : lines) {
      left(lineIn(place, line, *font_, kNoteSize), kBright);
      place = {{place.low.x, place.high.y}, {place.high.x, place.high.y + kNoteHeight}};
    }
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
        return paintField(row, focused, item.field->text().empty() ? kPlaceholder : kBright);
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

  void paintField(const MenuRow& row, bool focused, glm::vec4 colour) {
    box(row.control, 6, kField);
    left(row.value, colour);
    if (!focused) return;
    const float middle = (row.control.low.y + row.control.high.y) / 2;
    box({{row.caret, middle - 10}, {row.caret + 2, middle + 10}}, 0, kGold);
  }

  const MenuPage* page_;
  const MenuLook* look_;
  const Font* font_;
  OverlayWriter writer_;
};

}  // namespace

float endOfLeftColumn(glm::vec2 screen) {
  MenuPage page;
  page.place = MenuPage::Place::kLeft;
  return columnOf(page, screen).high.x;
}

bool MenuBox::contains(glm::vec2 place) const {
  return place.x >= low.x && place.x < high.x && place.y >= low.y && place.y < high.y;
}

MenuLayout layOut(const MenuPage& page, const Font& font, glm::vec2 screen, const MenuScroll& scroll) {
  MenuLayout layout;
  const MenuBox column = columnOf(page, screen);
  const TitleForm title = titleForm(page, screen);
  const float width = column.width() - 2 * kPadding;
  const float about = aboutHeight(page);
  const float room = column.height() - 2 * kPadding - title.height - about;
  const std::vector<std::string> notes = noteLines(page, font, width, room);
  const float noteHeight = notes.empty() ? 0 : kNoteHeight * static_cast<float>(notes.size()) + kPadding / 2;
  const float step = kRowHeight + kRowGap;
  const auto fitting = static_cast<std::size_t>(std::max(1.0F, (room - noteHeight + kRowGap) / step));
  const std::size_t visible = std::min(page.items.size(), fitting);
  const float height = 2 * kPadding + title.height + noteHeight + step * static_cast<float>(visible) -
                       (visible > 0 ? kRowGap : 0) + about;
  const float top = std::max(kScreenMargin, (screen.y - height) / 2);
  layout.panel = {{column.low.x, top}, {column.high.x, std::min(top + height, screen.y - kScreenMargin)}};
  const float left = column.low.x + kPadding;
  float y = top + kPadding;
  MenuBox titleBox{{left, y}, {left + width, y + title.height}};
  if (page.backMark) layout.back = takeBackMark(titleBox, font);
  layout.title = lineIn(titleBox, page.title, font, title.size);
  y += title.height;
  for (const std::string& note : notes) {
    layout.notes.push_back(lineIn({{left, y}, {left + width, y + kNoteHeight}}, note, font, kNoteSize));
    y += kNoteHeight;
  }
  y = top + kPadding + title.height + noteHeight;
  layout.first = firstRow(page, scroll, visible);
  const float rowsTop = y;
  for (std::size_t i = layout.first; i < std::min(layout.first + visible, page.items.size()); ++i, y += step) {
    layout.rows.push_back(rowOf(page, i, {{left, y}, {left + width, y + kRowHeight}}, font));
  }
  if (about > 0) layout.about = {{left, y - kRowGap + kPadding / 2}, {left + width, y - kRowGap + about}};
  if (visible < page.items.size()) addScrollBar(layout, page.items.size(), visible, rowsTop, y - kRowGap);
  return layout;
}

Overlay paintMenu(const MenuPage& page, const MenuLayout& layout, const MenuLook& look, const Font& font, float width) {
  Painter painter(page, look, font);
  painter.paintSheet(layout, width);
  for (const MenuRow& row : layout.rows) painter.paintRow(row);
  painter.paintAbout(layout.about);
  return painter.take();
}

}  // namespace platon
