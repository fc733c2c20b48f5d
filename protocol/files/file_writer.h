#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/files/text_file.h"
#include "protocol/work/worker.h"

namespace platon {

/// Replaces the content of a file without waiting for the disk: a thread writes. A content that could not be written is
/// tried again.
class FileWriter {
 public:
  using Time = std::chrono::steady_clock::time_point;
  /// Writes a content to the file at a path. Returns why that failed, or an empty text. Called from the thread.
  using Replace = std::function<std::string(const std::string& path, std::string_view content)>;

  /// Time from a failure to the next try.
  static constexpr std::chrono::seconds kRetryInterval{10};
  /// Longest time that `finish` waits for one write.
  static constexpr std::chrono::seconds kFinishTime{5};

  explicit FileWriter(std::string path, ThreadStart start = startThread, Replace replace = replaceTextFile);
  /// Writes what is pending, unless `finish` has tried that since the last call of `write`.
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Queues a content for the file. It replaces one that is still queued.
  void write(std::string content);
  /// Starts to write what is queued if no other write is in progress. Call now and then. Returns why the last content
  /// could not be written, or that the disk has not answered for kRetryInterval; of the same content, each reason once
  /// in a row.
  std::optional<std::string> poll(Time now);
  /// Tries once to write what is pending, and waits for at most `limit` for a write in progress and then for its own.
  /// Returns why the file does not hold the last content; nothing if it does.
  std::optional<std::string> finish(std::chrono::milliseconds limit = kFinishTime);
  /// Whether the newest content is not in the file yet, perhaps because it could not be written.
  bool pending() const { return pending_; }
  /// How many failures `poll` has seen so far: writes that failed, and each kRetryInterval without an answer of the
  /// disk.
  std::uint64_t failures() const { return failures_; }

 private:
  void start();
  std::string faultOf(JobResult<std::string> written);
  std::string check(Time now);

  std::string path_;
  Replace replace_;
  std::string content_;  // the newest
  bool queued_ = false;  // the newest content waits for a write to start
  bool pending_ = false;
  bool finished_ = false;  // `finish` was called after the last `write`
  std::string reported_;   // the last reason
  std::uint64_t failures_ = 0;
  Time retryAt_{};               // when to try again what has failed
  Time answerBy_{};              // when a write in progress counts as failed
  Worker<std::string> writing_;  // the reason of a failure, or an empty text
};

}  // namespace platon
