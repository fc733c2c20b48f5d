#include "client/editor/edited_level.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace platon {
namespace {

bool isBefore(const EditedSegment& left, const EditedSegment& right) {
  const auto key = [](const EditedSegment& segment) {
    const SegmentWord& word = segment.word;
    return std::tuple(segment.face, segment.a.x, segment.a.y, segment.b.x, segment.b.y, word.kind, word.numbers);
  };
  return key(left) < key(right);
}

std::vector<EditedSegment> ordered(std::vector<EditedSegment> segments) {
  std::sort(segments.begin(), segments.end(), isBefore);
  return segments;
}

std::set<int> textLinesWithErrors(const LevelDocument& document) {
  std::set<int> textLines;
  for (const Diagnostic& found : document.diagnostics()) {
    if (found.error) textLines.insert(found.line);
  }
  return textLines;
}

}  // namespace

void UndoHistory::keep(std::string before) {
  future_.clear();
  past_.push_back(std::move(before));
  std::size_t bytes = std::accumulate(past_.begin(), past_.end(), std::size_t{0},
                                      [](std::size_t sum, const std::string& text) { return sum + text.size(); });
  while (past_.size() > 1 && (past_.size() > kMaxTexts || bytes > kMaxBytes)) {
    bytes -= past_.front().size();
    past_.pop_front();
  }
}

std::optional<std::string> UndoHistory::move(std::deque<std::string>& from, std::deque<std::string>& to,
                                             std::string present) {
  if (from.empty()) return std::nullopt;
  to.push_back(std::move(present));
  std::string text = std::move(from.back());
  from.pop_back();
  return text;
}

EditedLevel::EditedLevel(std::string_view text, bool saved) : document_(text) {
  if (!document_.valid() && !showValidPart(true)) showValidPart(false);
  update();
  if (saved) markSaved();
}

// Faults that are not those of a segment, such as a start that a segment blocks, need the level without segments.
bool EditedLevel::showValidPart(bool withSegments) {
  LevelDocument part = document_;
  const std::set<int> faulty = textLinesWithErrors(document_);
  std::vector<bool> leftOut(part.segments().size());
  for (std::size_t i = 0; i < leftOut.size(); ++i)
    leftOut[i] = !withSegments || faulty.contains(document_.textLineOf(i));
  part.erase(leftOut);
  part.check();
  if (!part.valid()) return false;
  shown_ = ordered(part.segments());
  part.setText(document_.text());
  part.check();
  document_ = std::move(part);
  return true;
}

void EditedLevel::edit(const std::function<void(LevelDocument&)>& change) {
  change(document_);
  std::string before = text_;
  if (document_.text() == before) return;
  history_.keep(std::move(before));
  document_.check();
  update();
}

bool EditedLevel::undo() { return show(history_.undo(text_)); }

bool EditedLevel::redo() { return show(history_.redo(text_)); }

bool EditedLevel::show(const std::optional<std::string>& text) {
  if (!text) return false;
  document_.setText(*text);
  document_.check();
  update();
  return true;
}

void EditedLevel::reload(std::string_view text) {
  edit([&](LevelDocument& document) { document.setText(text); });
  markSaved();
}

void EditedLevel::update() {
  text_ = document_.text();
  faulty_.clear();
  const std::shared_ptr<const Level>& level = document_.level();
  if (level && (!idle_ || idle_->sharedLevel() != level)) {
    stage_ = makeStageModel(*level);
    idle_.emplace(level);
  }
  std::vector<EditedSegment> present = ordered(document_.segments());
  if (document_.valid()) {
    shown_ = std::move(present);
    return;
  }
  std::set_difference(present.begin(), present.end(), shown_.begin(), shown_.end(), std::back_inserter(faulty_),
                      isBefore);
  faulty_.resize(std::min(faulty_.size(), kMaxFaulty));
}

}  // namespace platon
