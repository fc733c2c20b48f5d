#include "client/play/replace_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace platon {
namespace {

namespace fs = std::filesystem;

// Returns the file behind `path` if that is a symbolic link: a rename would replace the link.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

}  // namespace

std::optional<std::string> replaceFile(const fs::path& path, std::string_view text) {
  const fs::path target = resolved(path);
  fs::path unfinished = target;
  unfinished += ".new";
  std::error_code error;
  errno = 0;
  std::ofstream file(unfinished, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
  if (!file) {
    const std::string fault = "cannot write '" + unfinished.string() + "': " + std::strerror(errno);
    fs::remove(unfinished, error);
    return fault;
  }
  const fs::perms former = fs::status(target, error).permissions();
  if (!error && fs::exists(target)) fs::permissions(unfinished, former, error);
  fs::rename(unfinished, target, error);
  if (!error) return std::nullopt;
  const std::string fault = "cannot replace '" + target.string() + "': " + error.message();
  fs::remove(unfinished, error);
  return fault;
}

}  // namespace platon
