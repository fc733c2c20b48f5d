#include "client/menu/menu.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "client/menu/menu_layout.h"

namespace platon {
namespace {

constexpr double kRowsPerNotch = 2;
constexpr float kTwitch = 4;  // a pointer that moves no farther rests; units of the menu

std::size_t firstFocus(const MenuPage& page) {
  const auto found =
      std::find_if(page.items.begin(), page.items.end(), [](const MenuItem& item) { return item.canHaveFocus(); });
  return static_cast<std::size_t>(found - page.items.begin());
}

// An item that can have the focus: a page may have fewer items than before.
std::size_t validFocus(const MenuPage& page, std::size_t focus) {
  return focus < page.items.size() && page.items[focus].canHaveFocus() ? focus : firstFocus(page);
}

const MenuRow* rowAt(const MenuLayout& layout, glm::vec2 place) {
  const auto found = std::find_if(layout.rows.begin(), layout.rows.end(),
                                  [place](const MenuRow& row) { return row.box.contains(place); });
  return found == layout.rows.end() ? nullptr : &*found;
}

const MenuRow* rowOf(const MenuLayout& layout, std::size_t item) {
  const auto found =
      std::find_if(layout.rows.begin(), layout.rows.end(), [item](const MenuRow& row) { return row.item == item; });
  return found == layout.rows.end() ? nullptr : &*found;
}

bool hasValue(const MenuItem& item) {
  return item.kind == MenuItem::Kind::kChoice || item.kind == MenuItem::Kind::kSlider ||
         item.kind == MenuItem::Kind::kToggle;
}

}  // namespace

void Menu::resize(float width, float scale) {
  width_ = width;
  scale_ = scale;
  screen_ = glm::vec2(width, Overlay::kHeight) / scale;
}

void Menu::open(PageMaker page) {
  pages_.clear();
  push(std::move(page));
}

void Menu::push(PageMaker page) {
  const std::size_t focus = firstFocus(page());
  pages_.push_back({std::move(page), focus, 0});
  rest_ = pointer_;
  note(Feedback::kChosen);
  aside_ = dragging_ = false;
}

void Menu::back() {
  if (!isOpen()) return;
  pages_.pop_back();
  note(Feedback::kChosen);
  aside_ = dragging_ = false;
}

void Menu::close() {
  if (isOpen()) note(Feedback::kChosen);
  pages_.clear();
}

// By the player.
void Menu::focusOn(std::size_t item) {
  if (item != focus()) note(Feedback::kMoved);
  setFocus(item);
}

void Menu::choose(const MenuItem& item) {
  note(Feedback::kChosen);
  item.choose();
}

void Menu::setFocus(std::size_t item) { pages_.back().focus = item; }

Menu::Command Menu::commandOf(const KeyEvent& event) {
  const bool first = event.kind == KeyEvent::Kind::kPress;
  switch (event.key) {
    case Key::kArrowUp:
    case Key::kW:
    case Key::kPadUp:
      return Command::kUp;
    case Key::kArrowDown:
    case Key::kS:
    case Key::kPadDown:
      return Command::kDown;
    case Key::kArrowLeft:
    case Key::kA:
    case Key::kPadLeft:
      return Command::kLess;
    case Key::kArrowRight:
    case Key::kD:
    case Key::kPadRight:
      return Command::kMore;
    case Key::kSpace:
    case Key::kEnter:
    case Key::kPadA:
      return first && !event.alt ? Command::kChoose : Command::kNone;
    case Key::kEscape:
    case Key::kPadB:
    case Key::kPadStart:
      return first ? Command::kBack : Command::kNone;
    default:
      return Command::kNone;
  }
}

MenuPage Menu::present() const {
  MenuPage page = pages_.back().make();
  page.backMark = page.backMark && (page.back || pages_.size() > 1);
  return page;
}

MenuPage Menu::make() {
  MenuPage page = present();
  setFocus(validFocus(page, focus()));
  return page;
}

void Menu::handle(const KeyEvent& event, const Font& font) {
  if (!isOpen() || event.kind == KeyEvent::Kind::kRelease) return;
  rest_ = pointer_;
  const MenuPage page = make();
  if (page.takeKey) {
    if (event.kind == KeyEvent::Kind::kPress) note(Feedback::kChosen);
    return page.takeKey(event);
  }
  const MenuItem& item = page.items[focus()];
  if (item.field != nullptr && item.field->handle(event, clipboard_)) return;
  if (event.kind == KeyEvent::Kind::kCharacter) return;
  const Command command = commandOf(event);
  const bool changes = command == Command::kLess || command == Command::kMore;
  if (event.kind == KeyEvent::Kind::kRepeat && changes && !item.repeats()) return;
  if (command != Command::kNone) perform(command, page);
  if (isOpen()) pages_.back().first = layout(font).first;
}

void Menu::perform(Command command, const MenuPage& page) {
  aside_ = false;
  const MenuItem& item = page.items[focus()];
  switch (command) {
    case Command::kUp:
      return moveFocus(page, -1);
    case Command::kDown:
      return moveFocus(page, 1);
    case Command::kLess:
      return change(page, -1);
    case Command::kMore:
      return change(page, 1);
    case Command::kChoose:
      if (item.choose) return choose(item);
      return item.field != nullptr ? moveFocus(page, 1) : change(page, 1);
    default:
      return leave(page);
  }
}

void Menu::leave(const MenuPage& page) {
  if (page.back) {
    note(Feedback::kChosen);
    return page.back();
  }
  if (pages_.size() > 1) back();
}

void Menu::moveFocus(const MenuPage& page, int direction) {
  const std::size_t count = page.items.size();
  std::size_t item = focus();
  do {
    item = (item + count + static_cast<std::size_t>(direction)) % count;
  } while (!page.items[item].canHaveFocus());
  focusOn(item);
}

void Menu::change(const MenuPage& page, int direction) {
  const MenuItem& item = page.items[focus()];
  if (!hasValue(item)) return;
  aside_ = page.standsAside;
  note(Feedback::kMoved);
  item.step(direction);
}

void Menu::handle(const PointerEvent& event, const Font& font) {
  const glm::vec2 place = glm::vec2(event.place) / scale_;
  pointer_ = place;
  if (!isOpen()) return;
  const MenuPage page = make();
  if (page.takeKey) return event.kind == PointerEvent::Kind::kPress ? page.takeKey({Key::kEscape}) : void();
  switch (event.kind) {
    case PointerEvent::Kind::kMove:
      return rests(place) ? void() : point(page, place, font);
    case PointerEvent::Kind::kPress:
      if (goesBack(event)) return perform(Command::kBack, page);
      if (event.button == PointerEvent::Button::kLeft) press(page, place, font);
      return;
    case PointerEvent::Kind::kRelease:
      aside_ = aside_ && !dragging_;
      dragging_ = false;
      return;
    case PointerEvent::Kind::kScroll:
      return scroll(page, event, place, font);
  }
}

// Only a pointer that moves takes the focus from the keys.
bool Menu::rests(glm::vec2 place) {
  if (rest_ && glm::distance(*rest_, place) > kTwitch) rest_.reset();
  return rest_.has_value();
}

void Menu::point(const MenuPage& page, glm::vec2 place, const Font& font) {
  const MenuLayout shown = layoutOf(page, font, true);
  if (dragging_) {
    const MenuRow* const row = rowOf(shown, focus());
    return row != nullptr ? drag(page, *row, place) : void();
  }
  const MenuRow* const row = rowAt(shown, place);
  if (row == nullptr || !page.items[row->item].canHaveFocus()) return;
  aside_ = aside_ && row->item == focus();
  pages_.back().first = shown.first;
  focusOn(row->item);
}

void Menu::press(const MenuPage& page, glm::vec2 place, const Font& font) {
  point(page, place, font);
  const MenuLayout shown = layoutOf(page, font, true);
  if (!aside_ && shown.back.box.contains(place)) return perform(Command::kBack, page);
  const MenuRow* const row = rowAt(shown, place);
  if (row != nullptr && row->item == focus()) click(page, *row, place);
}

void Menu::click(const MenuPage& page, const MenuRow& row, glm::vec2 place) {
  const MenuItem& item = page.items[row.item];
  if (item.choose) return choose(item);
  if (item.kind == MenuItem::Kind::kSlider) {
    dragging_ = place.x >= row.control.low.x - 8;
    return dragging_ ? drag(page, row, place) : void();
  }
  const bool less =
      item.kind == MenuItem::Kind::kChoice && place.x >= row.control.low.x && place.x < row.value.box.low.x;
  change(page, less ? -1 : 1);
}

void Menu::drag(const MenuPage& page, const MenuRow& row, glm::vec2 place) {
  if (!page.items[row.item].set) {  // the page has changed under the pointer
    dragging_ = false;
    return;
  }
  aside_ = page.standsAside;
  const double part = (place.x - row.control.low.x) / std::max(row.control.width(), 1.0F);
  page.items[row.item].set(std::clamp(part, 0.0, 1.0));
  if (pages_.back().make().items[row.item].value != page.items[row.item].value) note(Feedback::kMoved);
}

// The focus stays under the pointer, or goes with the rows.
void Menu::scroll(const MenuPage& page, const PointerEvent& event, glm::vec2 place, const Font& font) {
  Shown& shown = pages_.back();
  const double first = static_cast<double>(layoutOf(page, font, true).first) - event.scroll * kRowsPerNotch;
  shown.first = static_cast<std::size_t>(std::clamp(first, 0.0, static_cast<double>(page.items.size())));
  const MenuLayout rows = layoutOf(page, font, false);
  shown.first = rows.first;
  const MenuRow* const under = rowAt(rows, place);
  if (under != nullptr && page.items[under->item].canHaveFocus()) return focusOn(under->item);
  if (rowOf(rows, focus()) != nullptr) return;
  const bool above = focus() < rows.first;
  setFocus(above ? rows.rows.front().item : rows.rows.back().item);
  if (!page.items[focus()].canHaveFocus()) moveFocus(page, above ? 1 : -1);
}

MenuLayout Menu::layoutOf(const MenuPage& page, const Font& font, bool followsFocus) const {
  const MenuScroll scroll{pages_.back().first, followsFocus ? std::optional(validFocus(page, focus())) : std::nullopt};
  return layOut(page, font, screen_, scroll);
}

MenuLayout Menu::layout(const Font& font) const { return layoutOf(present(), font, true); }

bool Menu::showsMotion() const {
  if (!isOpen() || !aside_) return false;
  const MenuPage page = present();
  return page.items[validFocus(page, focus())].inMotion;
}

Overlay Menu::overlay(const Font& font, bool dimsPicture) const {
  if (!isOpen()) return {};
  const MenuPage page = present();
  const MenuLook look{validFocus(page, focus()), aside_, dimsPicture, scale_};
  return paintMenu(page, layoutOf(page, font, true), look, font, width_);
}

}  // namespace platon
