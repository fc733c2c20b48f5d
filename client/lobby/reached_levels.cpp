#include "client/lobby/reached_levels.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "client/lobby/kept_file.h"
#include "protocol/files/text_file.h"
#include "protocol/hash_text.h"

namespace platon {
namespace {

constexpr const char* kHead = "# Levels whose goal you have reached: the hash of each.\n";
constexpr std::size_t kMaxBytes = ReachedLevels::kMaxLevels * 32;

}  // namespace

ReachedLevels::ReachedLevels(std::filesystem::path file) : file_(std::move(file)) { read(); }

bool ReachedLevels::read() {
  if (file_.empty()) return true;
  const std::optional<std::string> text = readKeptFile(file_, kMaxBytes);
  if (!text) return false;
  levels_.clear();
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (const std::optional<std::uint64_t> hash = hashIn(line)) levels_.push_back(*hash);
  }
  return true;
}

bool ReachedLevels::has(std::uint64_t level) const {
  return std::find(levels_.begin(), levels_.end(), level) != levels_.end();
}

// Another program may have added some.
std::string ReachedLevels::add(std::uint64_t level) {
  if (file_.empty() || has(level)) return {};
  const bool isRead = read();
  if (has(level)) return {};
  levels_.push_back(level);
  if (!isRead) return faultOf("cannot be read");
  if (levels_.size() > kMaxLevels) levels_.erase(levels_.begin(), levels_.end() - kMaxLevels);
  std::string text = kHead;
  for (const std::uint64_t each : levels_) text += hashText(each) + "\n";
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);  // writing reports the error
  const std::string fault = replaceCachedFile(file_.string(), text);
  return fault.empty() ? fault : faultOf(fault);
}

std::string ReachedLevels::faultOf(const std::string& reason) const {
  return "that the goal was reached is not kept: " + file_.string() + ": " + reason;
}

}  // namespace platon
