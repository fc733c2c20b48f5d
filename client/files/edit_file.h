#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "protocol/files/file_watch.h"

namespace platon {

/// The level file of the editor. Knows which text it has read or written last.
class EditFile {
 public:
  explicit EditFile(std::filesystem::path path) : path_(std::move(path)), watch_({path_.string()}) {}

  const std::filesystem::path& path() const { return path_; }
  bool exists() const;
  /// Returns the text of the file. Throws ProgramError::kUsage if it cannot be read.
  std::string load();
  /// Replaces the file, so that it is never half written. Returns why it cannot be written; nothing if it is written.
  std::optional<std::string> save(const std::string& text);
  /// Returns the text of the file if another program has written it since the last `load`, `save` or change returned.
  std::optional<std::string> takeChange();
  /// As takeChange, but looks from time to time only, and does not read what is just being written.
  std::optional<std::string> pollChange(FileWatch::Time now);

 private:
  std::filesystem::path path_;
  FileWatch watch_;
  std::string text_;
};

}  // namespace platon
