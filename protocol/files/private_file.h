#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <variant>

#include "protocol/files/descriptor.h"
#include "protocol/files/text_file.h"
#include "protocol/files/word_reader.h"

namespace platon {

/// Opens a file that this program writes for itself, for reading and writing. Makes it if it is missing. A new one
/// may be read by its owner only, and so may from now on an older one of this user, unless it has a second name: that
/// may be another file. Only a regular file is opened, never a symbolic link, which somebody else may have put there.
/// Never waits.
OpenedFile openPrivateFile(const std::string& path);

/// Whether a file was locked.
enum class LockResult : std::uint8_t {
  kLocked,
  kHeld,     ///< another program holds the lock
  kNoLocks,  ///< the file system has no locks
};

/// Longest time that a program waits for another one to unlock a file. Below FileWriter::kFinishTime.
inline constexpr std::chrono::milliseconds kLockTime{2000};

/// Locks a file as flock does until it is closed. Tries again and again for at most `limit`, so a program that keeps
/// the lock delays this one only so long.
LockResult lockFile(const Descriptor& file, std::chrono::milliseconds limit = kLockTime);

/// What to do where a file system has no locks.
enum class WithoutLocks : std::uint8_t { kRefuse, kGoOn };

/// Locks `path`.lock, a private file beside a file that is itself replaced when it is written, so that one program at a
/// time changes it. On failure why, and how to mend it. The lock lasts as long as the file is open.
OpenedFile lockBeside(const std::string& path, WithoutLocks without);

/// The sentence for a lock on the file at this path that another program holds: what is wrong and how to mend it.
std::string lockFault(const std::string& path);

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
