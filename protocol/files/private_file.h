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

/// A file in which programs remember something, a text: the one way in which all of them read, lock and write such a
/// file. One program at a time changes it, with a lock on the file with `.lock` added to its name, or to that of the
/// file to which a link leads. So nothing that another one has added is lost. A file that cannot be read as a whole is
/// never written, and one that is written holds all of the old text or all of the new one at any time. What is wrong is
/// told as a clause; if it lies in the file, in its folder or in the lock, the clause also says how to mend it.
class KeptFile {
 public:
  enum class Kind : std::uint8_t {
    kOwn,        ///< of the program, for its user only: its folder is made, and others may no longer read an older file
    kNamed,      ///< named by the user: its folder must exist, and an older file keeps its access rights
    kPublished,  ///< as kNamed, but everybody may read a new one, and its file system must have locks
  };
  using Wait = FileReplacement::Wait;
  /// Makes the new text from what the file holds, or says why it must stay.
  using Edit = std::function<std::variant<std::string, ParseError>(const std::string& text)>;

  /// An empty path: there is no file, and nothing is kept.
  KeptFile(std::filesystem::path path, std::size_t maxBytes, Kind kind = Kind::kOwn)
      : path_(std::move(path)), maxBytes_(maxBytes), kind_(kind) {}

  /// The text; empty if there is no file yet. On failure why it cannot be read: also a link to nothing and a text of
  /// more than `maxBytes` cannot.
  std::variant<std::string, ParseError> read() const;
  /// Replaces the text if the edit changes it. Waits for another program that changes the file, for at most kLockTime.
  /// Returns why that failed, or an empty text. The file stays as it is if the edit throws.
  std::string change(const Edit& edit, Wait wait = Wait::kForDisk) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  bool isMissing() const;
  std::string lockedFile() const;
  std::string faultOf(const std::string& text, const char* verb) const;

  std::filesystem::path path_;
  std::size_t maxBytes_;
  Kind kind_;
};

}  // namespace platon
