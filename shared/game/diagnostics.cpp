#include "platon/game/diagnostics.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace platon {

std::string format(std::string_view file, const Diagnostic& diagnostic) {
  return std::string(file) + ":" + std::to_string(diagnostic.line) + ":" + std::to_string(diagnostic.column) +
         (diagnostic.error ? ": error: " : ": warning: ") + diagnostic.message;
}

void Diagnostics::add(TextPosition at, bool error, std::string message) {
  hasError_ = hasError_ || error;
  Diagnostic diagnostic{at.line, at.column, error, std::move(message)};
  full_ = full_ || found_.size() == kMax;
  if (full_ && error && !warnings_.empty()) {
    found_[warnings_.back()] = std::move(diagnostic);
    warnings_.pop_back();
  }
  if (full_) return;
  if (!error) warnings_.push_back(found_.size());
  found_.push_back(std::move(diagnostic));
}

std::vector<Diagnostic> Diagnostics::take() {
  std::stable_sort(found_.begin(), found_.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  });
  if (full_) {
    const Diagnostic last = found_.back();
    found_.push_back({last.line, last.column, hasError_, "too many errors and warnings; fix these first"});
  }
  return std::move(found_);
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 32;
  std::string result = "'";
  for (const char byte : text.substr(0, longest)) result += byte >= ' ' && byte <= '~' ? byte : '?';
  if (text.size() > longest) result += "...";
  return result + "'";
}

}  // namespace platon
