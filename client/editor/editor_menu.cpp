#include "client/editor/editor_menu.h"

#include "client/ui/overlay.h"

namespace platon {

void EditorMenu::resize(std::uint32_t w, std::uint32_t h, double uiScale) {
  menu_.resize(Overlay::widthFor(w, h), textScale(uiScale, h));
}

void EditorMenu::open() {
  if (!menu_.isOpen()) menu_.open([this] { return page(); });
}

MenuPage EditorMenu::page() {
  const bool unsaved = level_.unsaved();
  MenuPage page{unsaved ? "The level has unsaved changes" : "Platon: level editor"};
  page.items.push_back({.name = "Back", .choose = [this] { close(); }});
  const auto saveAndLeave = [this] {
    menu_.close();
    leavesWhenSaved_ = wantsSave_ = true;
  };
  if (unsaved) page.items.push_back({.name = "Save and leave", .choose = saveAndLeave});
  page.items.push_back(
      {.name = unsaved ? "Leave without saving" : "Leave the editor", .choose = [this] { leaving_ = true; }});
  page.back = [this] { close(); };
  page.backMark = false;
  return page;
}

void EditorMenu::close() {
  menu_.close();
  leavesWhenSaved_ = false;
}

void EditorMenu::endSave(bool saved) {
  if (saved && leavesWhenSaved_) leaving_ = true;
  if (!saved) leavesWhenSaved_ = false;
}

}  // namespace platon
