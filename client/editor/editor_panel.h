#pragma once

#include <string>
#include <vector>

#include "client/editor/edited_segment.h"
#include "client/editor/editor_tools.h"
#include "client/editor/level_analysis.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"

namespace platon {

/// What the panel of the editor shows.
struct EditorStatus {
  std::string file;      ///< its name
  std::string title;     ///< of the level
  bool unsaved = false;  ///< the text differs from the file
  EditTool tool = EditTool::kSelect;
  SegmentWord word;      ///< of the selected segment, else of the next one that is drawn
  double grid = 10;      ///< level units
  std::string place;     ///< of the pointer; empty beside the solid
  std::string message;   ///< the last event; empty: none
  std::string error;     ///< why the text is not valid; empty: it is valid
  bool playing = false;  ///< a ball is played
  bool arrived = false;  ///< and has touched the goal
  bool help = false;     ///< show the table of keys
  LevelReport report;
};

/// What a report says, a line of text each.
std::vector<std::string> linesOf(const LevelReport& report);

/// "oneway", "door 3" or "segment".
std::string nameOf(const SegmentWord& word);

/// The panel, which never covers the middle of the picture. `screen` is the size of the screen.
Overlay makeEditorPanel(const EditorStatus& status, const Font& font, glm::vec2 screen);

}  // namespace platon
