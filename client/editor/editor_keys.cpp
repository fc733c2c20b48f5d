#include <algorithm>
#include <numbers>
#include <utility>

#include "client/editor/editor.h"

// What the keys do in the editor.
namespace platon {
namespace {

constexpr double kTurn = 6 * std::numbers::pi / 180;  // by one press of an arrow key
constexpr double kNotches = 1;                        // by one press of Page Up

int digitOf(Key key) { return static_cast<int>(key) - static_cast<int>(Key::kDigit0); }

}  // namespace

void Editor::handle(const KeyEvent& event) {
  if (menu_.isOpen()) {
    if (event.kind == KeyEvent::Kind::kRelease) mapper_.handle(event, true);
    return menu_.handle(event, font_);
  }
  if (event.kind == KeyEvent::Kind::kCharacter) return;
  if (event.key == Key::kF11 && event.kind == KeyEvent::Kind::kPress) fullscreen_ = !fullscreen_;
  if (event.key == Key::kF1 && event.kind == KeyEvent::Kind::kPress) help_ = !help_;
  if (play_) return handleInPlay(event);
  if (event.kind == KeyEvent::Kind::kRelease || turnView(event)) return;
  if (event.ctrl) return handleCommand(event);
  if (event.kind == KeyEvent::Kind::kPress) handleEdit(event.key, event.shift);
}

void Editor::askToLeave() {
  if (!menu_.isOpen()) menu_.open([this] { return leavePage(); });
}

MenuPage Editor::leavePage() {
  const bool unsaved = level_.unsaved();
  MenuPage page{unsaved ? "The level has unsaved changes" : "Platon: level editor"};
  page.items.push_back({.name = "Back", .choose = [this] { closeMenu(); }});
  if (unsaved) page.items.push_back({.name = "Save and leave", .choose = [this] { saveAndLeave(); }});
  page.items.push_back(
      {.name = unsaved ? "Leave without saving" : "Leave the editor", .choose = [this] { leaving_ = true; }});
  page.back = [this] { closeMenu(); };
  page.backMark = false;
  return page;
}

void Editor::closeMenu() {
  menu_.close();
  leaveWhenSaved_ = false;
}

void Editor::saveAndLeave() {
  menu_.close();
  leaveWhenSaved_ = wantsSave_ = true;
}

void Editor::handleInPlay(const KeyEvent& event) {
  const bool ends = event.key == Key::kEscape && event.kind == KeyEvent::Kind::kPress;
  if (ends) play_.reset();
  const bool isCommand = event.ctrl && event.kind != KeyEvent::Kind::kRelease;
  if (!ends && !isCommand) mapper_.handle(event, false);
}

bool Editor::turnView(const KeyEvent& event) {
  switch (event.key) {
    case Key::kArrowLeft:
      view_.turn(kTurn, 0);
      return true;
    case Key::kArrowRight:
      view_.turn(-kTurn, 0);
      return true;
    case Key::kArrowUp:
      view_.turn(0, -kTurn);
      return true;
    case Key::kArrowDown:
      view_.turn(0, kTurn);
      return true;
    case Key::kPageUp:
      view_.zoom(mesh(), kNotches);
      return true;
    case Key::kPageDown:
      view_.zoom(mesh(), -kNotches);
      return true;
    default:
      return false;
  }
}

void Editor::handleCommand(const KeyEvent& event) {
  const bool redo = event.key == Key::kY || (event.key == Key::kZ && event.shift);
  const bool undo = event.key == Key::kZ && !event.shift;
  if (event.key == Key::kS) wantsSave_ = true;
  if (!undo && !redo) return;
  const bool done = undo ? level_.undo() : level_.redo();
  message_ = done ? "" : undo ? "nothing to undo" : "nothing to redo";
  selected_.reset();
  showLevel();
}

void Editor::handleEdit(Key key, bool shift) {
  const auto tool =
      std::find_if(kEditTools.begin(), kEditTools.end(), [&](const EditToolFacts& facts) { return facts.key == key; });
  if (tool != kEditTools.end()) return choose(tool->tool);
  if (key >= Key::kDigit0 && key <= Key::kDigit9) return typeDigit(digitOf(key));
  digits_ = 0;
  switch (key) {
    case Key::kEscape:
      return escape();
    case Key::kC:
      return centre();
    case Key::kX:
      if (selected_) return cycleWord(*selected_, shift);
      word_ = nextWord(word_, shift);
      return;
    case Key::kF:
      return flip();
    case Key::kDelete:
    case Key::kBackspace:
      return eraseSelected();
    case Key::kPlus:
      return changeGrid(1);
    case Key::kMinus:
      return changeGrid(-1);
    case Key::kH:
      showReached_ = !showReached_;
      return setReport(std::move(report_));
    default:
      return;
  }
}

void Editor::choose(EditTool tool) {
  tool_ = tool;
  digits_ = 0;
  gesture_.reset();
  if (tool != EditTool::kSelect) selected_.reset();
}

// A second digit belongs to the first one, as far as both are a number of doors.
void Editor::typeDigit(int digit) {
  SegmentWord word = selected_ ? segments()[*selected_].word : word_;
  const int both = word.number * 10 + digit;
  const bool isSecond = digits_ == 1 && both < static_cast<int>(kMaxDoorNumbers);
  digits_ = isSecond ? 2 : 1;
  word.number = isSecond ? both : digit;
  if (word.kind == ElementKind::kUp) word.number = digit % mesh().solid().edgesPerFace();
  word_ = word;
  if (!selected_ || !word.kind || !hasNumber(*word.kind)) return;
  EditedSegment changed = segments()[*selected_];
  changed.word = word;
  edit([&](LevelDocument& document) { document.replace(*selected_, changed); });
}

void Editor::changeGrid(int step) {
  grid_ = static_cast<std::size_t>(std::clamp(static_cast<int>(grid_) + step, 0, static_cast<int>(kGrids.size()) - 1));
}

void Editor::eraseSelected() {
  if (!selected_) return;
  const std::size_t segment = *std::exchange(selected_, std::nullopt);
  edit([&](LevelDocument& document) { document.erase(segment); });
}

// Changes the direction of the selected segment, or with the tool for the start the up of the ball.
void Editor::flip() {
  if (tool_ == EditTool::kStart) {
    const int degrees = (shown_->startAngle.centidegrees() / 100 + turnOfStart()) % 360;
    return edit([&](LevelDocument& document) { document.turnStart(degrees); });
  }
  if (!selected_) return;
  EditedSegment turned = segments()[*selected_];
  std::swap(turned.a, turned.b);
  edit([&](LevelDocument& document) { document.replace(*selected_, turned); });
}

void Editor::escape() {
  if (gesture_) {
    gesture_.reset();
  } else if (selected_) {
    selected_.reset();
  } else {
    askToLeave();
  }
}

}  // namespace platon
