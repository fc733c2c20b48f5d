#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "client/editor/edited_level.h"
#include "client/editor/editor_marks.h"
#include "client/editor/gesture.h"
#include "client/editor/picking.h"
#include "client/editor/snapping.h"
#include "client/scene/camera.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"

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

/// Changes the level with the chosen tool: what the pointer, its left button and the keys of the tools do. Holds what
/// is under the pointer, what is selected, and the segment that follows the pointer. The tool kPlay changes nothing.
class EditorTools {
 public:
  /// `level` has a level and must outlive the object.
  explicit EditorTools(EditedLevel& level) : level_(level) {}

  /// The pointer has moved over the picture that `seen` has taken.
  void move(const PointerEvent& event, const Camera& seen);
  /// The left button was pressed on the solid, or released. These return whether the level was edited.
  bool press(const PointerEvent& event, const Camera& seen);
  bool release();
  /// A key was pressed.
  bool handle(Key key, bool shift);
  /// The text was replaced as a whole: what was selected is no more.
  void letGo();

  EditTool tool() const { return tool_; }
  /// Of the selected segment, else of the next one that is drawn.
  SegmentWord word() const { return selected_ ? segments()[*selected_].word : word_; }
  double grid() const { return kGrids[grid_]; }
  /// Place of the pointer on the solid.
  const std::optional<FacePlace>& pointer() const { return pointer_; }
  /// Whether a segment is selected or follows the pointer.
  bool isHolding() const { return selected_ || gesture_; }
  /// What is marked in the picture that `seen` takes.
  FaceMarks marks(const Camera& seen) const;

 private:
  static constexpr std::array<double, 6> kGrids{1, 5, 10, 20, 40, 60};  // level units

  const SolidMesh& mesh() const { return level_.stage()->mesh; }
  const std::vector<EditedSegment>& segments() const { return level_.document().segments(); }
  SnapOptions snapOptions(const Camera& seen) const;
  bool edit(const std::function<void(LevelDocument&)>& change);
  bool beginMove();
  bool cycleWord(std::size_t segment, bool back);
  bool flip();
  bool eraseSelected();
  bool typeDigit(int digit);
  void choose(EditTool tool);

  EditedLevel& level_;
  EditTool tool_ = EditTool::kSelect;
  SegmentWord word_;                  // of the next segment
  std::size_t typed_ = 0;             // index of the number to which digits belong
  bool typing_ = false;               // the digits of that number
  std::size_t grid_ = 2;              // index into kGrids
  std::optional<FacePlace> pointer_;  // on the solid
  bool free_ = false;                 // Alt is held
  std::optional<PickedSegment> hovered_;
  std::optional<std::size_t> selected_;
  std::optional<Gesture> gesture_;
};

}  // namespace platon
