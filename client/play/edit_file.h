#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace platon {

/// The level file of the editor. Knows which text it has read or written last.
class EditFile {
 public:
  explicit EditFile(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  bool exists() const;
  /// Returns the text of the file. Throws ProgramError::kUsage if it cannot be read.
  std::string load();
  /// Replaces the file by a rename, so that it is never half written. Returns why it cannot be written; nothing if it
  /// is written.
  std::optional<std::string> save(const std::string& text);
  /// Returns the text of the file if another program has changed it since the last call, `load` or `save`.
  std::optional<std::string> takeChange();

 private:
  // What tells two versions of a file apart.
  struct Stamp {
    std::filesystem::file_time_type time{};
    std::uintmax_t size = 0;

    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  Stamp stamp() const;

  std::filesystem::path path_;
  std::string text_;
  Stamp known_;
};

}  // namespace platon
