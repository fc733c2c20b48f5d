#include "client/lobby/reached_levels.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "protocol/files/word_reader.h"
#include "protocol/hash_text.h"

namespace platon {
namespace {

constexpr const char* kHead = "# Levels whose goal you have reached: the hash of each.\n";
constexpr std::size_t kMaxBytes = ReachedLevels::kMaxLevels * 32;

std::vector<std::uint64_t> levelsIn(const std::string& text) {
  std::vector<std::uint64_t> levels;
  for (TextLines lines(text); lines.nextEntry();) {
    if (const std::optional<std::uint64_t> hash = hashIn(lines.line())) levels.push_back(*hash);
  }
  return levels;
}

}  // namespace

ReachedLevels::ReachedLevels(std::filesystem::path file) : file_(std::move(file), kMaxBytes) {
  const auto text = file_.read();
  if (const auto* const kept = std::get_if<std::string>(&text)) levels_ = levelsIn(*kept);
}

bool ReachedLevels::has(std::uint64_t level) const {
  return std::find(levels_.begin(), levels_.end(), level) != levels_.end();
}

// Another program may have added some.
std::string ReachedLevels::add(std::uint64_t level) {
  if (file_.path().empty() || has(level)) return {};
  levels_.push_back(level);
  const auto addTo = [&](const std::string& kept) {
    levels_ = levelsIn(kept);
    if (!has(level)) levels_.push_back(level);
    if (levels_.size() > kMaxLevels) levels_.erase(levels_.begin(), levels_.end() - kMaxLevels);
    std::string text = kHead;
    for (const std::uint64_t each : levels_) text += hashText(each) + "\n";
    return text;
  };
  const std::string fault = file_.change(addTo, FileReplacement::Wait::kNot);
  if (fault.empty()) return {};
  return "that the goal was reached is not kept: " + file_.path().string() + ": " + fault;
}

}  // namespace platon
