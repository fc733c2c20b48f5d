#pragma once

#include <string>

#include "protocol/files/descriptor.h"

namespace platon {

/// Where the console of a server listens if no path is given: in the user's folder for such files, or else in /tmp.
/// `runtimeFolder`: value of XDG_RUNTIME_DIR; null or empty: not set.
std::string defaultConsolePath(const char* runtimeFolder, unsigned user);
/// The same for this process.
std::string defaultConsolePath();

/// Throws ProgramError (kUsage) if no console can be opened at the path, whether another server uses it or not. Opens
/// and removes nothing.
void checkConsolePath(const std::string& path);

/// A Unix socket that listens at a path and that only its user can connect to. The destructor removes it.
class ConsoleSocket {
 public:
  /// Replaces the socket of a server that no longer runs. Throws ProgramError: kFailed if a server listens there,
  /// kUsage if the path is another kind of file or if no socket can be made there.
  explicit ConsoleSocket(std::string path);
  ~ConsoleSocket();
  ConsoleSocket(const ConsoleSocket&) = delete;
  ConsoleSocket& operator=(const ConsoleSocket&) = delete;

  const std::string& path() const { return path_; }
  const Descriptor& listener() const { return listener_; }

 private:
  void replaceStale() const;
  bool bindAndListen();

  std::string path_;
  Descriptor listener_;
  // Tells whether the file at the path is still this socket.
  unsigned long long device_ = 0;
  unsigned long long inode_ = 0;
};

}  // namespace platon
