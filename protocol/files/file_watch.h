#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace platon {

/// Notices when files change, by their time and size. A change counts once the file has stayed the same from one look
/// to the next, so that nobody reads a file that is just being written. A file that is removed has changed, too.
class FileWatch {
 public:
  using Time = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::milliseconds kInterval{250};

  /// Watches files as they are now.
  explicit FileWatch(std::vector<std::string> files);

  const std::vector<std::string>& files() const { return files_; }
  /// Looks at the files, unless the last look was less than kInterval ago. Returns whether a file has changed since
  /// this returned true last, or since the construction.
  bool poll(Time now);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;

    friend bool operator==(const Stamp&, const Stamp&) = default;
  };

  std::vector<Stamp> look() const;

  std::vector<std::string> files_;
  std::vector<Stamp> known_;
  std::vector<Stamp> last_;
  Time nextLook_{};
};

}  // namespace platon
