#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/files/text_file.h"

namespace platon::sim {

/// The first `maxBytes` bytes of a file. Throws UsageError when it cannot be read.
std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t maxBytes);

/// A file opened for writing. Throws UsageError when it cannot be opened, InputError when a write fails.
class OutputFile {
 public:
  enum class Mode {
    kReplace,    ///< replaces an existing file when it is closed, and no pipe and no device
    kInPlace,    ///< writes into an existing file, pipe or device, from which another program may read meanwhile
    kCreateNew,  ///< refuses an existing file
  };

  OutputFile(const std::string& path, Mode mode);

  void write(std::string_view text) { write(text.data(), text.size()); }
  void write(std::span<const std::uint8_t> bytes) { write(bytes.data(), bytes.size()); }
  /// Ends the file; must be called after the last write.
  void close();

 private:
  void write(const void* bytes, std::size_t count);
  [[noreturn]] void fail(const std::string& reason) const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::optional<FileReplacement> replacement_;  // of kReplace
  std::unique_ptr<std::FILE, Close> file_;      // of the others
};

}  // namespace platon::sim
