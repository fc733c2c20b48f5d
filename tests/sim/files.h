#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace platon::sim {

/// The content of a file, of a longer one the first `most` bytes; throws UsageError when it cannot be read.
std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t most);

/// A file that is written from its start. Throws UsageError when it cannot be opened and InputError when what was
/// written did not arrive.
class OutputFile {
 public:
  /// What may be lost for it.
  enum class Over { kAnything, kNothing };

  explicit OutputFile(const std::string& path, Over over = Over::kAnything);

  void write(std::string_view text) { write(text.data(), text.size()); }
  void write(std::span<const std::uint8_t> bytes) { write(bytes.data(), bytes.size()); }
  /// To be called after the last write.
  void close();

 private:
  void write(const void* bytes, std::size_t count);
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace platon::sim
