#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "protocol/files/descriptor.h"

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

}  // namespace platon
