#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/editor/level_document.h"
#include "client/editor/undo_history.h"

namespace platon {

/// A level document with its history and what of it is saved.
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

  /// Segments of a text that is not valid, which level() lacks, the first kMaxFaulty in order of face and place. Empty
  /// while the text is valid.
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
};

}  // namespace platon
