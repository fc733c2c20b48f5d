#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <string_view>

#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>

namespace spdlog {
class async_logger;
namespace details {
class thread_pool;
}
}  // namespace spdlog

namespace platon {

/// The end of an asynchronous spdlog logger: writes each message and a line feed to a file descriptor. When nobody
/// reads the descriptor it waits, until `discard` is called; when it is closed, lines are dropped. Used by one thread,
/// except for `discard` and the future.
class DescriptorSink : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  explicit DescriptorSink(int descriptor) : descriptor_(descriptor) {}

  /// Drops all lines from now on, also one that is being written.
  void discard() { discarding_ = true; }
  /// Ready once the first flush has been handled, that is, all lines before it were written.
  std::future<void> flushed() { return flushed_.get_future(); }

 protected:
  void sink_it_(const spdlog::details::log_msg& message) override;
  void flush_() override;

 private:
  bool waitUntilWritable() const;

  int descriptor_;
  std::atomic<bool> discarding_{false};
  std::promise<void> flushed_;
  bool flushHandled_ = false;
};

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
