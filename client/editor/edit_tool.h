#pragma once

#include <array>
#include <cstdint>

#include "client/ui/key.h"

namespace platon {

/// What the left button of the mouse does in the editor.
enum class EditTool : std::uint8_t { kSelect, kDraw, kErase, kWord, kStart, kGoal, kPlay };

struct EditToolFacts {
  EditTool tool;
  Key key;
  const char* letter;  ///< of the key
  const char* name;
};

/// All tools, in the order of EditTool.
inline constexpr std::array<EditToolFacts, 7> kEditTools{{{EditTool::kSelect, Key::kS, "S", "select and move"},
                                                          {EditTool::kDraw, Key::kD, "D", "draw"},
                                                          {EditTool::kErase, Key::kE, "E", "erase"},
                                                          {EditTool::kWord, Key::kW, "W", "word"},
                                                          {EditTool::kStart, Key::kT, "T", "start"},
                                                          {EditTool::kGoal, Key::kG, "G", "goal"},
                                                          {EditTool::kPlay, Key::kP, "P", "play"}}};

}  // namespace platon
