#pragma once

#include <spdlog/details/null_mutex.h>
#include <spdlog/sinks/base_sink.h>

#include <atomic>
#include <future>
#include <string_view>

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

}  // namespace platon
