#include "client/files/session_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <span>
#include <system_error>

#include "client/files/server_file_name.h"
#include "protocol/files/private_file.h"

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

}  // namespace platon
