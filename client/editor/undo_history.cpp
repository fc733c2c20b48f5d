#include "client/editor/undo_history.h"

#include <numeric>
#include <utility>

namespace platon {

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

}  // namespace platon
