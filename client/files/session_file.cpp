#include "client/files/session_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <span>
#include <system_error>

#include "client/files/server_file_name.h"

namespace platon {

namespace {

constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

int openForOwner(const std::filesystem::path& path) {
  return open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, kOwnerOnly);
}

// Locks the file. `removed`: locked, but its previous owner has removed it from the folder.
bool lock(int handle, bool& removed) {
  struct stat status {};
  const bool locked = flock(handle, LOCK_EX | LOCK_NB) == 0 && fstat(handle, &status) == 0;
  removed = locked && status.st_nlink == 0;
  return locked && !removed;
}

}  // namespace

SessionFile::SessionFile(const std::filesystem::path& folder, const ServerAddress& server) {
  if (folder.empty()) return;
  std::error_code ignored;  // openForOwner fails then
  std::filesystem::create_directories(folder, ignored);
  path_ = folder / serverFileName(server);
  for (bool removed = true; removed;) {
    handle_ = openForOwner(path_);
    if (handle_ < 0 || lock(handle_, removed)) return;
    close(handle_);
    handle_ = -1;
  }
}

SessionFile::~SessionFile() {
  if (!token()) forget();
  if (handle_ >= 0) close(handle_);
}

std::optional<SessionToken> SessionFile::token() const {
  std::array<std::uint8_t, SessionToken().size() + 1> bytes;
  const ssize_t count = handle_ < 0 ? -1 : pread(handle_, bytes.data(), bytes.size(), 0);
  return tokenOf(std::span(bytes).first(count < 0 ? 0 : static_cast<std::size_t>(count)));
}

// Empties the file first: a half-written file holds no token.
void SessionFile::keep(const SessionToken& token) {
  if (handle_ < 0) return;
  const bool ready = fchmod(handle_, kOwnerOnly) == 0 && ftruncate(handle_, 0) == 0;
  if (ready) (void)!pwrite(handle_, token.data(), token.size(), 0);
}

// Removes the file while it is locked: after that, the name may belong to the file of another client.
void SessionFile::forget() {
  if (handle_ < 0) return;
  unlink(path_.c_str());
  close(handle_);
  handle_ = -1;
}

}  // namespace platon
