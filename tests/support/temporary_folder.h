#pragma once

#include <filesystem>

namespace platon {

/// A new folder, deleted with its contents by the destructor.
class TemporaryFolder {
 public:
  /// In TMPDIR. Throws std::system_error if the folder cannot be made.
  TemporaryFolder() : TemporaryFolder(std::filesystem::temp_directory_path()) {}
  /// In /tmp, wherever TMPDIR is: the path of a socket has at most 107 bytes. Throws as the constructor does.
  static TemporaryFolder forSockets() { return TemporaryFolder("/tmp"); }
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The path of a file or folder in it.
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

 private:
  explicit TemporaryFolder(const std::filesystem::path& parent);

  std::filesystem::path path_;
};

}  // namespace platon
