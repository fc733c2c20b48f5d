#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <variant>

#include "protocol/files/parse_error.h"
#include "protocol/files/text_file.h"

namespace platon {

/// A file in which the programs of a user remember something, a text. One program at a time changes it, so nothing that
/// another one has added is lost, and a file that cannot be read as a whole is never written.
class KeptFile {
 public:
  /// Makes the new text from what the file holds.
  using Edit = std::function<std::string(const std::string& text)>;

  /// An empty path: there is no file, and nothing is kept.
  KeptFile(std::filesystem::path path, std::size_t maxBytes) : path_(std::move(path)), maxBytes_(maxBytes) {}

  /// The text; empty if there is no file yet. On failure why it cannot be read: also one of more than `maxBytes`
  /// cannot.
  std::variant<std::string, ParseError> read() const;
  /// Replaces the text, and makes the folder of the file if it is missing. Waits for another program that changes the
  /// file, for at most kLockTime. Returns why that failed, or an empty text.
  std::string change(const Edit& edit, FileReplacement::Wait wait) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::size_t maxBytes_;
};

}  // namespace platon
