#include "client/play/edit_file.h"

#include <fstream>
#include <iterator>
#include <system_error>

#include "client/play/replace_file.h"
#include "platon/game/level.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

// At most one byte more than a level may have.
std::optional<std::string> readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || !fs::is_regular_file(path)) return std::nullopt;
  std::string text(kMaxLevelBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return file.bad() ? std::nullopt : std::optional(text);
}

}  // namespace

bool EditFile::exists() const {
  std::error_code ignored;
  return fs::exists(path_, ignored);
}

std::string EditFile::load() {
  known_ = stamp();
  const std::optional<std::string> text = readText(path_);
  if (!text) {
    throw ProgramError(ProgramError::kUsage,
                       "cannot read the level '" + path_.string() + "'; name a readable level file, or a new one");
  }
  text_ = *text;
  return text_;
}

std::optional<std::string> EditFile::save(const std::string& text) {
  if (const auto fault = replaceFile(path_, text)) return fault;
  text_ = text;
  known_ = stamp();
  return std::nullopt;
}

std::optional<std::string> EditFile::takeChange() {
  const Stamp now = stamp();
  if (now == known_) return std::nullopt;
  known_ = now;
  std::optional<std::string> text = readText(path_);
  if (!text || *text == text_) return std::nullopt;
  text_ = *text;
  return text;
}

EditFile::Stamp EditFile::stamp() const {
  std::error_code ignored;
  const fs::file_time_type time = fs::last_write_time(path_, ignored);
  const std::uintmax_t size = fs::file_size(path_, ignored);
  return {time, size};
}

}  // namespace platon
