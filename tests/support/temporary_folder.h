#pragma once

#include <filesystem>

namespace platon::oracle {

/// A new folder for files that are needed only as long as this object lives.
class TemporaryFolder {
 public:
  /// Throws std::system_error when there is no room for it.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  /// Removes it with all that is in it.
  ~TemporaryFolder();

  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace platon::oracle
