#include "client/editor/leave_menu.h"

#include <cstddef>

#include "client/ui/overlay_writer.h"

namespace platon {
namespace {

const char* nameOf(LeaveMenu::Choice choice, bool unsaved) {
  if (choice == LeaveMenu::Choice::kBack) return "Back";
  if (choice == LeaveMenu::Choice::kSaveAndLeave) return "Save and leave";
  return unsaved ? "Leave without saving" : "Leave the editor";
}

}  // namespace

void LeaveMenu::open(bool unsaved) {
  open_ = true;
  unsaved_ = unsaved;
  item_ = 0;
}

std::vector<LeaveMenu::Choice> LeaveMenu::items() const {
  if (unsaved_) return {Choice::kBack, Choice::kSaveAndLeave, Choice::kLeave};
  return {Choice::kBack, Choice::kLeave};
}

std::optional<LeaveMenu::Choice> LeaveMenu::handle(const KeyEvent& event) {
  if (!open_ || event.kind == KeyEvent::Kind::kRelease) return std::nullopt;
  const std::size_t count = items().size();
  if (event.key == Key::kArrowUp) item_ = (item_ + count - 1) % count;
  if (event.key == Key::kArrowDown) item_ = (item_ + 1) % count;
  if (event.kind != KeyEvent::Kind::kPress) return std::nullopt;
  if (event.key == Key::kEscape) item_ = 0;
  if (event.key != Key::kEnter && event.key != Key::kSpace && event.key != Key::kEscape) return std::nullopt;
  open_ = false;
  return items()[item_];
}

Overlay LeaveMenu::overlay(const Font& font, float width) const {
  OverlayWriter writer(font);
  if (!open_) return writer.take();
  constexpr float kRowHeight = 40;
  const std::vector<Choice> all = items();
  const glm::vec2 half(200, kRowHeight * static_cast<float>(all.size()) / 2 + 44);
  const glm::vec2 middle(width / 2, Overlay::kHeight / 2);
  writer.panel({0, 0}, {width, Overlay::kHeight}, 0, {0.02F, 0.02F, 0.05F, 0.55F});
  writer.panel(middle - half, middle + half, 18, {0.07F, 0.08F, 0.13F, 0.96F});
  writer.centred(unsaved_ ? "The level has unsaved changes" : "Platon: level editor",
                 {middle.x, middle.y - half.y + 42}, 20, overlay_colours::kBright);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const float top = middle.y - half.y + 64 + kRowHeight * static_cast<float>(i);
    if (i == item_) {
      writer.panel({middle.x - half.x + 16, top}, {middle.x + half.x - 16, top + kRowHeight - 4}, 9,
                   overlay_colours::kSelected);
    }
    writer.centred(nameOf(all[i], unsaved_), {middle.x, top + 24}, 18,
                   i == item_ ? overlay_colours::kBright : overlay_colours::kSoft);
  }
  return writer.take();
}

}  // namespace platon
