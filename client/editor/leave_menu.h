#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "client/ui/font.h"
#include "client/ui/key.h"
#include "client/ui/overlay.h"

namespace platon {

/// The menu of the editor: back, or leave, with or without saving.
class LeaveMenu {
 public:
  enum class Choice { kBack, kSaveAndLeave, kLeave };

  bool isOpen() const { return open_; }
  /// Opens the menu at its first item. With `unsaved` changes it asks what becomes of them.
  void open(bool unsaved);
  /// Moves through the menu. Returns what the user chooses; the menu is closed then.
  std::optional<Choice> handle(const KeyEvent& event);

  /// The picture of the menu; empty while it is closed. `width` is that of the virtual screen.
  Overlay overlay(const Font& font, float width) const;

 private:
  std::vector<Choice> items() const;

  bool open_ = false;
  bool unsaved_ = false;
  std::size_t item_ = 0;
};

}  // namespace platon
