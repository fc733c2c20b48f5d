#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "protocol/files/descriptor.h"
#include "protocol/files/word_reader.h"

namespace platon {

/// A file that was opened, or why it was not.
struct OpenedFile {
  Descriptor file;
  std::string fault;  ///< a clause, such as the reason of the system; empty: the file is open
};

/// Whether a pipe is opened, too, such as that of `<(command)` in a shell. Reading it waits for those who have opened
/// it for writing; if nobody has, it is empty.
enum class Pipes : std::uint8_t { kRefuse, kRead };

/// Opens a file of the user or the operator for reading. It may be anything: a named pipe would keep the program
/// waiting, and a device may have no end. So only a regular file is opened, perhaps through a symbolic link. Never
/// waits.
OpenedFile openToRead(const std::string& path, Pipes pipes = Pipes::kRefuse);

/// Why the file at a path is not a regular file; empty if it is one, or if there is none.
std::string faultOfKind(const std::string& path);

/// The same for what is open under a number of a descriptor.
std::string faultOfKind(const Descriptor& file);

/// Reads the next `count` bytes of a file. Returns how many there were, which is less than `count` only at the end;
/// nothing if reading fails, with the reason in errno.
std::optional<std::size_t> readNext(const Descriptor& file, void* bytes, std::size_t count);

/// Reads a file to its end, but at most `maxBytes`, without so much memory for a shorter one. `content`: std::string or
/// a vector of bytes. False if reading fails, with the reason in errno.
template <class Content>
bool readUpTo(const Descriptor& file, std::size_t maxBytes, Content& content) {
  constexpr std::size_t part = std::size_t{1} << 16;
  for (;;) {
    const std::size_t had = content.size();
    content.resize(std::min(maxBytes, had + part));
    const auto got = readNext(file, content.data() + had, content.size() - had);
    content.resize(had + got.value_or(0));
    if (!got || *got == 0) return got.has_value();
  }
}

/// The content of a file that openToRead opens, of which at most one byte more than `maxBytes` is read. On failure why
/// it cannot be opened, or the reason of the system.
std::variant<std::string, ParseError> readTextFile(const std::string& path, std::size_t maxBytes,
                                                   Pipes pipes = Pipes::kRefuse);

/// A new content of a file, written in pieces beside it. `finish` replaces the file; without it the file stays as it
/// was, and nothing is left. Replaces no named pipe and no device, and keeps a symbolic link.
class FileReplacement {
 public:
  enum class Wait : std::uint8_t { kForDisk, kNot };
  /// Who may read a new file, whatever the umask. `kOnlyOwner`: an older file is closed to others, too.
  enum class Readers : std::uint8_t { kOwnerIfNew, kAllIfNew, kOnlyOwner };

  /// The reason of a failure is in `fault`, and all below do nothing then.
  explicit FileReplacement(const std::string& path);
  ~FileReplacement();
  FileReplacement(const FileReplacement&) = delete;
  FileReplacement& operator=(const FileReplacement&) = delete;

  void write(std::string_view content);
  /// Puts the content in the place of the file, which keeps its access rights. Returns why that failed, or an empty
  /// text.
  std::string finish(Wait wait = Wait::kNot, Readers readers = Readers::kAllIfNew);
  const std::string& fault() const { return fault_; }

 private:
  std::string target_;
  std::string temporary_;
  Descriptor file_;  // none: finished, or failed
  std::string fault_;
};

/// Replaces the content of a file: at any time the file holds all of the old content or all of the new one, also after
/// a power failure. Keeps the access rights of the file, and a symbolic link to it; only its owner may read a new file.
/// Replaces no named pipe and no device. Returns why that failed, or an empty text. May wait for the disk.
std::string replaceTextFile(const std::string& path, std::string_view content);

/// As replaceTextFile, but does not wait for the disk: after a power failure the file may be empty or the old one. For
/// what can be made again.
std::string replaceCachedFile(const std::string& path, std::string_view content);

/// As replaceCachedFile, but everybody may read a new file: for what the user has asked for, and can ask for again.
std::string replaceOutputFile(const std::string& path, std::string_view content);

/// The path of the folder of a file.
std::string folderOf(const std::string& file);

/// Makes the new name of a file last through a power failure. Some file systems cannot do so, and need not. False if
/// that fails, with the reason in errno.
bool syncFolder(const std::string& file);

}  // namespace platon
