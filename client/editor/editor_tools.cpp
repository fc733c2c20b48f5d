#include "client/editor/editor_tools.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "platon/game/game.h"

namespace platon {
namespace {

constexpr double kReach = 9;  // of the pointer, units of the virtual screen

constexpr int kUsualTicks = kTicksPerSecond;  // of a timed segment, solid and open

// The largest number that the word may have. One that needs none may become any other.
int lastNumberOf(const SegmentWord& word, int edges) {
  const auto last = [edges](ElementKind kind) {
    return static_cast<int>(rangeOf(kind, static_cast<std::uint32_t>(edges)).last);
  };
  if (word.count() > 0) return last(*word.kind);
  int most = 0;
  for (const ElementKind kind : kElementKinds) most = std::max(most, last(kind));
  return most;
}

// The word with numbers that it may have.
SegmentWord fitted(SegmentWord word, int edges) {
  for (std::size_t i = 0; i < word.count(); ++i) {
    const NumberRange range = rangeOf(*word.kind, static_cast<std::uint32_t>(edges));
    const auto number = static_cast<std::uint32_t>(word.numbers[i]);
    if (number >= range.first && number <= range.last) continue;
    const bool isTime = traitsOf(*word.kind).number == ElementNumber::kTicks;
    word.numbers[i] = isTime ? kUsualTicks : static_cast<int>(number % (range.last + 1));
  }
  return word;
}

// The words follow each other in a ring; 0 is that of a segment without a word.
SegmentWord wordBeside(const SegmentWord& word, bool back, int edges) {
  const std::size_t count = kElementKinds.size() + 1;
  const std::size_t now = word.kind ? static_cast<std::size_t>(*word.kind) + 1 : 0;
  const std::size_t next = (now + (back ? count - 1 : 1)) % count;
  if (next == 0) return {std::nullopt, word.numbers};
  return fitted({kElementKinds[next - 1], word.numbers}, edges);
}

// The indices of segments change when pieces on other faces are added. Of equal ones, any is as good.
std::optional<std::size_t> find(const std::vector<EditedSegment>& segments, const EditedSegment& segment) {
  constexpr double kRounding = 1e-4;
  const auto found = std::find_if(segments.begin(), segments.end(), [&](const EditedSegment& other) {
    return other.face == segment.face && other.word == segment.word && glm::distance(other.a, segment.a) < kRounding &&
           glm::distance(other.b, segment.b) < kRounding;
  });
  if (found == segments.end()) return std::nullopt;
  return static_cast<std::size_t>(found - segments.begin());
}

// Half the angle of an edge, in which the up of the start is turned on triangles and pentagons; degrees.
int turnOfStart(const SolidMesh& mesh) {
  const int edges = mesh.solid().edgesPerFace();
  return edges == 3 ? 60 : edges == 4 ? 90 : 36;
}

// The up of a start on the face, degrees: nearly that of the picture.
int upOfStart(const SolidMesh& mesh, int face, const Camera& seen) {
  const int turn = turnOfStart(mesh);
  return (static_cast<int>(std::lround(upOfPicture(mesh, face, seen) / turn)) * turn + 360) % 360;
}

}  // namespace

void EditorTools::move(const PointerEvent& event, const Camera& seen) {
  free_ = event.alt;
  pointer_ = pickFace(mesh(), seen, event.place);
  hovered_.reset();
  if (!pointer_) return;
  if (gesture_) {
    std::vector<EditedSegment> others = segments();
    if (gesture_->moved()) others.erase(others.begin() + static_cast<std::ptrdiff_t>(*gesture_->moved()));
    return gesture_->follow(*pointer_, others, snapOptions(seen), event.shift);
  }
  const bool picks = tool_ == EditTool::kSelect || tool_ == EditTool::kErase || tool_ == EditTool::kWord;
  if (picks) hovered_ = pickSegment(segments(), *pointer_, kReach / screenScale(mesh(), seen, *pointer_));
}

bool EditorTools::press(const PointerEvent& event, const Camera& seen) {
  typing_ = false;
  typed_ = 0;
  const FacePlace at{pointer_->face, snapped(mesh(), segments(), *pointer_, snapOptions(seen))};
  const std::optional<PickedSegment> picked = hovered_;
  switch (tool_) {
    case EditTool::kSelect:
      return beginMove();
    case EditTool::kDraw:
      selected_.reset();
      gesture_.emplace(mesh(), at, word_);
      return false;
    case EditTool::kErase:
      selected_.reset();
      return picked && edit([&](LevelDocument& document) { document.erase(picked->segment); });
    case EditTool::kWord:
      return picked && cycleWord(picked->segment, event.shift);
    case EditTool::kStart:
      return edit([&](LevelDocument& document) { document.setStart(at, upOfStart(mesh(), at.face, seen)); });
    case EditTool::kGoal:
      return edit([&](LevelDocument& document) { document.setGoal(at); });
    case EditTool::kPlay:
      return false;
  }
  return false;
}

// A segment that is moved over an edge becomes one piece on each face.
bool EditorTools::release() {
  if (!gesture_) return false;
  const std::vector<EditedSegment> pieces = gesture_->pieces();
  const std::optional<std::size_t> moved = gesture_->moved();
  gesture_.reset();
  if (pieces.empty() || (moved && pieces.size() == 1 && pieces.front() == segments()[*moved])) return false;
  edit([&](LevelDocument& document) {
    if (moved) document.replace(*moved, pieces.front());
    for (std::size_t i = moved ? 1 : 0; i < pieces.size(); ++i) document.add(pieces[i]);
  });
  if (moved) selected_ = find(segments(), pieces.front());
  return true;
}

bool EditorTools::handle(Key key, bool shift) {
  const auto tool =
      std::find_if(kEditTools.begin(), kEditTools.end(), [&](const EditToolFacts& facts) { return facts.key == key; });
  if (key >= Key::kDigit0 && key <= Key::kDigit9)
    return typeDigit(static_cast<int>(key) - static_cast<int>(Key::kDigit0));
  typing_ = false;
  typed_ = key == Key::kComma ? 1 : 0;
  if (tool != kEditTools.end()) choose(tool->tool);
  switch (key) {
    case Key::kEscape:
      gesture_ ? gesture_.reset() : selected_.reset();
      return false;
    case Key::kX:
      if (selected_) return cycleWord(*selected_, shift);
      word_ = wordBeside(word_, shift, mesh().solid().edgesPerFace());
      return false;
    case Key::kF:
      return flip();
    case Key::kDelete:
    case Key::kBackspace:
      return eraseSelected();
    case Key::kPlus:
      grid_ = std::min(grid_ + 1, kGrids.size() - 1);
      return false;
    case Key::kMinus:
      grid_ -= grid_ > 0 ? 1 : 0;
      return false;
    default:
      return false;
  }
}

void EditorTools::letGo() {
  selected_.reset();
  hovered_.reset();
  gesture_.reset();
  word_ = fitted(word_, mesh().solid().edgesPerFace());
  if (pointer_ && pointer_->face >= mesh().faces()) pointer_.reset();
}

FaceMarks EditorTools::marks(const Camera& seen) const {
  EditorMarks marks;
  if (hovered_ && !gesture_) marks.hovered = segments()[hovered_->segment];
  if (selected_ && !gesture_) marks.selected = segments()[*selected_];
  if (gesture_) marks.drawn = gesture_->pieces();
  marks.faulty = level_.faulty();
  const double scale = pointer_ ? screenScale(mesh(), seen, *pointer_) : 1;
  const bool aims = tool_ == EditTool::kDraw || tool_ == EditTool::kStart || tool_ == EditTool::kGoal;
  if (pointer_ && aims)
    marks.pointer = FacePlace{pointer_->face, snapped(mesh(), segments(), *pointer_, snapOptions(seen))};
  return marksAbove(marks, scale > 0.01 ? 2 / scale : 4);
}

SnapOptions EditorTools::snapOptions(const Camera& seen) const {
  // Start and goal belong between the segments, not onto them.
  if (tool_ == EditTool::kStart || tool_ == EditTool::kGoal) return {grid(), 0, free_};
  const double scale = pointer_ ? screenScale(mesh(), seen, *pointer_) : 1;
  return {grid(), kReach / std::max(scale, 0.05), free_};
}

// The indices of segments change with the text.
bool EditorTools::edit(const std::function<void(LevelDocument&)>& change) {
  level_.edit(change);
  if (selected_ && *selected_ >= segments().size()) selected_.reset();
  hovered_.reset();
  gesture_.reset();
  return true;
}

bool EditorTools::beginMove() {
  selected_.reset();
  if (!hovered_) return false;
  selected_ = hovered_->segment;
  gesture_.emplace(mesh(), segments()[*selected_], *hovered_, pointer_->place);
  return false;
}

bool EditorTools::cycleWord(std::size_t segment, bool back) {
  EditedSegment changed = segments()[segment];
  changed.word = wordBeside(changed.word, back, mesh().solid().edgesPerFace());
  edit([&](LevelDocument& document) { document.replace(segment, changed); });
  selected_ = segment;
  word_ = changed.word;
  return true;
}

// Changes the direction of the selected segment, or with the tool for the start the up of the ball.
bool EditorTools::flip() {
  if (tool_ == EditTool::kStart) {
    const int degrees = (level_.document().level()->startAngle.centidegrees() / 100 + turnOfStart(mesh())) % 360;
    return edit([&](LevelDocument& document) { document.turnStart(degrees); });
  }
  if (!selected_) return false;
  EditedSegment turned = segments()[*selected_];
  std::swap(turned.a, turned.b);
  return edit([&](LevelDocument& document) { document.replace(*selected_, turned); });
}

bool EditorTools::eraseSelected() {
  if (!selected_) return false;
  const std::size_t segment = *std::exchange(selected_, std::nullopt);
  return edit([&](LevelDocument& document) { document.erase(segment); });
}

// A digit belongs to those typed before it, as far as the word may have the number of all of them.
bool EditorTools::typeDigit(int digit) {
  const int edges = mesh().solid().edgesPerFace();
  SegmentWord word = this->word();
  int& number = word.numbers[word.count() > 1 ? typed_ : 0];
  const int all = number * 10 + digit;
  number = typing_ && all <= lastNumberOf(word, edges) ? all : digit;
  typing_ = true;
  word = fitted(word, edges);
  word_ = word;
  if (!selected_ || word.count() == 0) return false;
  EditedSegment changed = segments()[*selected_];
  changed.word = word;
  return edit([&](LevelDocument& document) { document.replace(*selected_, changed); });
}

void EditorTools::choose(EditTool tool) {
  tool_ = tool;
  gesture_.reset();
  if (tool != EditTool::kSelect) selected_.reset();
}

}  // namespace platon
