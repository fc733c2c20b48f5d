#include "client/files/server_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <span>
#include <string>
#include <system_error>
#include <variant>

#include "client/files/user_folders.h"
#include "protocol/files/bounded_folder.h"
#include "protocol/files/private_file.h"
#include "protocol/files/text_file.h"
#include "protocol/hash_text.h"

namespace platon {

namespace {

// Locks the file. `removed`: locked, but its previous owner has removed it from the folder.
bool lock(const Descriptor& file, bool& removed) {
  struct stat status {};
  const bool locked =
      lockFile(file, std::chrono::milliseconds(0)) == LockResult::kLocked && fstat(file.number(), &status) == 0;
  removed = locked && status.st_nlink == 0;
  return locked && !removed;
}

}  // namespace

SessionFile::SessionFile(const std::filesystem::path& folder, const ServerAddress& server) {
  if (folder.empty()) return;
  std::error_code ignored;  // the file cannot be opened then
  std::filesystem::create_directories(folder, ignored);
  path_ = folder / serverFileName(server);
  for (bool removed = true; removed;) {
    file_ = openPrivateFile(path_).file;
    if (!file_ || lock(file_, removed)) return;
    file_ = Descriptor();
  }
}

SessionFile::~SessionFile() {
  if (!token()) forget();
}

std::optional<SessionToken> SessionFile::token() const {
  std::array<std::uint8_t, SessionToken().size() + 1> bytes;
  const ssize_t count = !file_ ? -1 : pread(file_.number(), bytes.data(), bytes.size(), 0);
  return tokenOf(std::span(bytes).first(count < 0 ? 0 : static_cast<std::size_t>(count)));
}

// Empties the file first: a half-written file holds no token.
void SessionFile::keep(const SessionToken& token) {
  if (file_ && ftruncate(file_.number(), 0) == 0) (void)!pwrite(file_.number(), token.data(), token.size(), 0);
}

// Removes the file while it is locked: after that, the name may belong to the file of another client.
void SessionFile::forget() {
  if (!file_) return;
  unlink(path_.c_str());
  file_ = Descriptor();
}

namespace {

namespace fs = std::filesystem;

bool isLevelFile(const fs::path& path) { return hashIn(path.filename().string()).has_value(); }

// The levels in a folder and the folders in it, newest first.
std::vector<DatedFile> levelsIn(const fs::path& folder) { return newestFiles(folder, Subfolders::kWith, isLevelFile); }

}  // namespace

LevelCache::LevelCache(const fs::path& folder, const ServerAddress& server)
    : all_(folder), folder_(folder.empty() ? folder : folder / serverFileName(server)) {}

std::vector<std::uint64_t> LevelCache::newest(std::size_t count) const {
  std::vector<std::uint64_t> hashes;
  if (all_.empty()) return hashes;
  for (const DatedFile& level : levelsIn(folder_)) {
    if (hashes.size() < count) hashes.push_back(*hashIn(level.path.filename().string()));
  }
  return hashes;
}

std::shared_ptr<const Level> LevelCache::load(std::uint64_t hash) {
  if (all_.empty()) return nullptr;
  const fs::path path = folder_ / hashText(hash);
  std::error_code fault;
  if (!fs::is_regular_file(path, fault)) return nullptr;
  const auto text = readTextFile(path.string(), kMaxLevelBytes);
  const std::string* const content = std::get_if<std::string>(&text);
  std::shared_ptr<const Level> level = content == nullptr ? nullptr : loadLevel(*content).level;
  if (level && level->hash == hash) {
    keep(*level);  // makes it the newest
    return level;
  }
  fs::remove(path, fault);
  return nullptr;
}

// Runs in a frame of the game, so it does not wait for the disk. A file that is not a level is refused when it is read.
void LevelCache::keep(const Level& level) {
  if (all_.empty()) return;
  std::error_code fault;
  fs::create_directories(folder_, fault);
  (void)replaceCachedFile((folder_ / hashText(level.hash)).string(), level.text);  // if not kept, it is loaded again
  limit();
}

void LevelCache::limit() const {
  const std::vector<DatedFile> levels = levelsIn(all_);
  removeOldest(levels, kMaxLevels, kMaxBytes);
  std::error_code ignored;
  for (const DatedFile& level : levels) fs::remove(level.path.parent_path(), ignored);  // only if it is empty
}

}  // namespace platon
