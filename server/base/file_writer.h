#pragma once

#include <future>
#include <optional>
#include <string>

namespace platon {

/// Replaces the content of a file without waiting for the disk: a thread writes.
class FileWriter {
 public:
  explicit FileWriter(std::string path) : path_(std::move(path)) {}
  /// Writes what is queued.
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Queues a content for the file. It replaces one that is still queued.
  void write(std::string content);
  /// Starts to write what is queued if the thread is free. Call now and then. Returns why the last content could not be
  /// written, once.
  std::optional<std::string> poll();
  /// Whether the newest content is not in the file yet, perhaps because it could not be written.
  bool pending() const { return pending_; }

 private:
  void start();

  std::string path_;
  std::optional<std::string> queued_;
  std::future<std::string> writing_;  // the reason of a failure, or empty
  bool pending_ = false;
};

}  // namespace platon
