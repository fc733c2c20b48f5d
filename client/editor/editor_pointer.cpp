#include <algorithm>
#include <cstddef>

#include <glm/geometric.hpp>

#include "client/editor/editor.h"
#include "client/editor/face_picker.h"

// What the mouse does in the editor.
namespace platon {
namespace {

// The words follow each other in a ring; 0 is that of a segment without a word.
SegmentWord wordBeside(const SegmentWord& word, bool back) {
  const std::size_t count = kElementKinds.size() + 1;
  const std::size_t now = word.kind ? static_cast<std::size_t>(*word.kind) + 1 : 0;
  const std::size_t next = (now + (back ? count - 1 : 1)) % count;
  if (next == 0) return {std::nullopt, word.number};
  return {kElementKinds[next - 1], word.number};
}

}  // namespace

void Editor::handle(const PointerEvent& event) {
  using Kind = PointerEvent::Kind;
  if (menu_.isOpen()) {
    screen_ = event.place;
    if (event.kind == Kind::kRelease) turning_ = false;
    return menu_.handle(event, font_);
  }
  movePointer(event);
  if (event.kind == Kind::kScroll) view_.zoom(mesh(), event.scroll);
  if (event.kind == Kind::kMove) return;
  const bool left = event.button == PointerEvent::Button::kLeft;
  if (!left && event.kind != Kind::kScroll) turning_ = event.kind == Kind::kPress;
  if (left && event.kind == Kind::kPress && pointer_) press(event);
  if (left && event.kind == Kind::kRelease && gesture_) finishGesture();
}

void Editor::movePointer(const PointerEvent& event) {
  const glm::dvec2 way = event.place - screen_;
  screen_ = event.place;
  free_ = event.alt;
  if (turning_ && !play_) view_.drag(mesh(), way);
  const Camera seen = camera();
  pointer_ = pickFace(mesh(), seen, screen_);
  hovered_.reset();
  if (!pointer_ || play_) return;
  if (gesture_) {
    std::vector<EditedSegment> others = segments();
    if (gesture_->moved()) others.erase(others.begin() + static_cast<std::ptrdiff_t>(*gesture_->moved()));
    return gesture_->follow(*pointer_, others, snapOptions(event.alt), event.shift);
  }
  const bool picks = tool_ == EditTool::kSelect || tool_ == EditTool::kErase || tool_ == EditTool::kWord;
  if (picks) hovered_ = pickSegment(segments(), *pointer_, kReach / screenScale(mesh(), seen, *pointer_));
}

void Editor::press(const PointerEvent& event) {
  digits_ = 0;
  if (play_ || tool_ == EditTool::kPlay) return placeBall();
  const FacePlace at{pointer_->face, snapped(mesh(), segments(), *pointer_, snapOptions(event.alt))};
  const std::optional<PickedSegment> picked = hovered_;
  switch (tool_) {
    case EditTool::kSelect:
      return beginMove();
    case EditTool::kDraw:
      selected_.reset();
      gesture_.emplace(mesh(), at, word_);
      return;
    case EditTool::kErase:
      selected_.reset();
      if (picked) edit([&](LevelDocument& document) { document.erase(picked->segment); });
      return;
    case EditTool::kWord:
      if (picked) cycleWord(picked->segment, event.shift);
      return;
    case EditTool::kStart:
      return placeStart(at);
    case EditTool::kGoal:
      return edit([&](LevelDocument& document) { document.setGoal(at); });
    case EditTool::kPlay:
      return;
  }
}

void Editor::beginMove() {
  selected_.reset();
  if (!hovered_) return;
  selected_ = hovered_->segment;
  gesture_.emplace(mesh(), segments()[*selected_], *hovered_, pointer_->place);
}

// A segment that is moved over an edge becomes one piece on each face.
void Editor::finishGesture() {
  const std::vector<EditedSegment> pieces = gesture_->pieces();
  const std::optional<std::size_t> moved = gesture_->moved();
  gesture_.reset();
  if (pieces.empty() || (moved && pieces.size() == 1 && pieces.front() == segments()[*moved])) return;
  edit([&](LevelDocument& document) {
    if (moved) document.replace(*moved, pieces.front());
    for (std::size_t i = moved ? 1 : 0; i < pieces.size(); ++i) document.add(pieces[i]);
  });
  if (moved) selected_ = find(pieces.front());
}

SegmentWord Editor::nextWord(SegmentWord word, bool back) const {
  word = wordBeside(word, back);
  if (word.kind == ElementKind::kUp) word.number %= mesh().solid().edgesPerFace();
  return word;
}

// The indices of segments change when pieces on other faces are added. Of equal ones, any is as good.
std::optional<std::size_t> Editor::find(const EditedSegment& segment) const {
  constexpr double kRounding = 1e-4;
  const auto found = std::find_if(segments().begin(), segments().end(), [&](const EditedSegment& other) {
    return other.face == segment.face && other.word == segment.word && glm::distance(other.a, segment.a) < kRounding &&
           glm::distance(other.b, segment.b) < kRounding;
  });
  if (found == segments().end()) return std::nullopt;
  return static_cast<std::size_t>(found - segments().begin());
}

void Editor::cycleWord(std::size_t segment, bool back) {
  EditedSegment changed = segments()[segment];
  changed.word = nextWord(changed.word, back);
  edit([&](LevelDocument& document) { document.replace(segment, changed); });
  selected_ = segment;
  word_ = changed.word;
}

void Editor::placeStart(const FacePlace& at) {
  const int degrees = upOfStart(at.face);
  edit([&](LevelDocument& document) { document.setStart(at, degrees); });
}

}  // namespace platon
