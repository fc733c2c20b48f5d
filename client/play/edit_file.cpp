#include "client/play/edit_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "platon/game/level.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

// Returns the file behind `path` if that is a symbolic link: a rename would replace the link.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

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
  const fs::path target = resolved(path_);
  fs::path unfinished = target;
  unfinished += ".new";
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) return "cannot write '" + unfinished.string() + "': " + std::strerror(errno);
  std::error_code error;
  const fs::perms former = fs::status(target, error).permissions();
  if (!error && fs::exists(target)) fs::permissions(unfinished, former, error);
  fs::rename(unfinished, target, error);
  if (error) return "cannot replace '" + target.string() + "': " + error.message();
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
