#pragma once

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

/// Whether a named pipe is opened, too. Reading it then waits for whoever writes it.
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

}  // namespace platon
