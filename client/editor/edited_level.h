#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/editor/level_document.h"
#include "client/scene/stage_model.h"
#include "platon/game/game.h"

namespace platon {

/// The texts before and after the present one. Bounded: the oldest texts are forgotten first.
class UndoHistory {
 public:
  static constexpr std::size_t kMaxTexts = 1000;
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  /// Keeps the text as it was before an edit. What was undone can no longer be redone.
  void keep(std::string before);
  /// Returns the text before `present`; nothing if there is none.
  std::optional<std::string> undo(std::string present) { return move(past_, future_, std::move(present)); }
  /// Returns the text that was undone last; nothing if there is none.
  std::optional<std::string> redo(std::string present) { return move(future_, past_, std::move(present)); }

 private:
  static std::optional<std::string> move(std::deque<std::string>& from, std::deque<std::string>& to,
                                         std::string present);

  std::deque<std::string> past_;    // the latest last
  std::deque<std::string> future_;  // the next last
};

/// A level document with its history, what of it is saved, and what is drawn of it: the level of the last valid text.
class EditedLevel {
 public:
  /// Most faulty segments that are named: each is drawn in every picture.
  static constexpr std::size_t kMaxFaulty = 2000;

  /// `saved`: the text is that of the file. Of an invalid text, the level without its faulty segments is shown; if
  /// that is not valid either, there is no level.
  EditedLevel(std::string_view text, bool saved);

  const LevelDocument& document() const { return document_; }
  /// Changes the document in one step that can be undone. An edit that changes nothing is no step.
  void edit(const std::function<void(LevelDocument&)>& change);
  /// Takes back the last step, or repeats the next one. Returns whether there was one.
  bool undo();
  bool redo();

  bool unsaved() const { return !saved_ || *saved_ != text_; }
  const std::string& text() const { return text_; }
  /// The text is that of the file now.
  void markSaved() { saved_ = text_; }
  /// No text of this level is that of the file any more.
  void markUnsaved() { saved_.reset(); }
  /// Takes the text of the file, which another program has changed. This step can be undone.
  void reload(std::string_view text);

  /// The stage of document().level(), and its game, in which nobody plays. There is none without a level.
  const std::shared_ptr<const StageModel>& stage() const { return stage_; }
  const Game& idle() const { return *idle_; }
  /// Segments of a text that is not valid, which the level lacks, the first kMaxFaulty in order of face and place.
  /// Empty while the text is valid.
  const std::vector<EditedSegment>& faulty() const { return faulty_; }

 private:
  bool showValidPart(bool withSegments);
  bool show(const std::optional<std::string>& text);
  void update();

  LevelDocument document_;
  UndoHistory history_;
  std::string text_;
  std::optional<std::string> saved_;
  std::vector<EditedSegment> shown_;  // of the last valid text
  std::vector<EditedSegment> faulty_;
  std::shared_ptr<const StageModel> stage_;
  std::optional<Game> idle_;
};

}  // namespace platon
