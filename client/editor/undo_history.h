#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <utility>

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

}  // namespace platon
