#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace spdlog {
class async_logger;
namespace details {
class thread_pool;
}
}  // namespace spdlog

namespace platon {

class DescriptorSink;

/// Writes lines to a file descriptor from a thread of its own, by spdlog's asynchronous logger. The caller never waits
/// for the reader: when the queue is full the oldest lines are dropped, and when the reader has closed the descriptor
/// all are.
class AsyncLineWriter {
 public:
  /// Lines that the queue holds.
  static constexpr std::size_t kQueueLines = 2048;
  /// Longest time that the destructor waits for the reader.
  static constexpr std::chrono::milliseconds kFlushTime{1000};

  explicit AsyncLineWriter(int descriptor);
  /// Writes the queued lines. Lines that the reader has not taken within kFlushTime are dropped.
  ~AsyncLineWriter();
  AsyncLineWriter(const AsyncLineWriter&) = delete;
  AsyncLineWriter& operator=(const AsyncLineWriter&) = delete;

  /// Queues a line, given without its line feed.
  void write(std::string_view line);
  /// Lines dropped from the full queue since the last call. 0 as long as the queue is more than half full, so that a
  /// line which reports the number is not dropped as well.
  std::uint64_t takeDropped();

 private:
  std::shared_ptr<DescriptorSink> sink_;
  std::shared_ptr<spdlog::details::thread_pool> thread_;
  std::shared_ptr<spdlog::async_logger> logger_;
  std::uint64_t reportedDropped_ = 0;
};

}  // namespace platon
