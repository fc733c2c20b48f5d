#pragma once

#include <cstdint>
#include <utility>

#include "client/editor/edited_level.h"
#include "client/menu/menu.h"
#include "client/ui/font.h"
#include "client/ui/key.h"
#include "client/ui/overlay.h"
#include "client/ui/pointer_event.h"

namespace platon {

/// The menu of the editor, with which the user leaves. Asks what becomes of unsaved changes, and holds the wish to save
/// until it is taken.
class EditorMenu {
 public:
  /// `level` must outlive the object.
  explicit EditorMenu(const EditedLevel& level) : level_(level) {}
  EditorMenu(const EditorMenu&) = delete;
  EditorMenu& operator=(const EditorMenu&) = delete;

  /// For pictures of w × h pixels, enlarged as Settings::uiScale says.
  void resize(std::uint32_t w, std::uint32_t h, double uiScale);
  void open();
  bool isOpen() const { return menu_.isOpen(); }
  void handle(const KeyEvent& event) { menu_.handle(event, font_); }
  void handle(const PointerEvent& event) { menu_.handle(event, font_); }

  void askToSave() { wantsSave_ = true; }
  /// Whether the user has asked to save since the last call.
  bool takeSave() { return std::exchange(wantsSave_, false); }
  /// The level was saved, or could not be.
  void endSave(bool saved);
  /// Whether the user has left. With unsaved changes, they are to be dropped.
  bool leaving() const { return leaving_; }

  const Menu& menu() const { return menu_; }
  /// Empty while the menu is closed.
  Overlay overlay() const { return menu_.overlay(font_, true); }

 private:
  MenuPage page();
  void close();

  const EditedLevel& level_;
  Font font_;
  Menu menu_;
  bool wantsSave_ = false;
  bool leavesWhenSaved_ = false;
  bool leaving_ = false;
};

}  // namespace platon
