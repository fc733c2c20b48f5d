#include "server/program/async_line_writer.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <future>
#include <string>
#include <utility>

#include <spdlog/async_logger.h>
#include <spdlog/details/thread_pool.h>

#include "protocol/work/blocked_signals.h"

namespace platon {
namespace {

constexpr int kPollMs = 20;  // interval at which `discard` is checked

}  // namespace

// A pipe that is writable takes PIPE_BUF bytes without blocking. The descriptor is not made non-blocking, since other
// processes may share it.
void DescriptorSink::sink_it_(const spdlog::details::log_msg& message) {
  std::string line(message.payload.data(), message.payload.size());
  line += '\n';
  for (std::size_t written = 0; written < line.size() && waitUntilWritable();) {
    const std::size_t size = std::min<std::size_t>(line.size() - written, PIPE_BUF);
    const ssize_t result = ::write(descriptor_, line.data() + written, size);
    if (result < 0 && errno != EINTR && errno != EAGAIN) return;
    written += static_cast<std::size_t>(std::max<ssize_t>(result, 0));
  }
}

// True also when the descriptor is closed or its pipe has no reader: then `write` fails at once.
bool DescriptorSink::waitUntilWritable() const {
  while (!discarding_) {
    pollfd descriptor{descriptor_, POLLOUT, 0};
    if (poll(&descriptor, 1, kPollMs) > 0) return true;
  }
  return false;
}

void DescriptorSink::flush_() {
  if (!flushHandled_) flushed_.set_value();
  flushHandled_ = true;
}

namespace {

// A write to a closed pipe fails instead of raising SIGPIPE, which is blocked.
std::shared_ptr<spdlog::details::thread_pool> startPool(std::size_t queueLines) {
  const BlockedSignals blocked;
  return std::make_shared<spdlog::details::thread_pool>(queueLines, 1);
}

}  // namespace

AsyncLineWriter::AsyncLineWriter(int descriptor)
    : sink_(std::make_shared<DescriptorSink>(descriptor)),
      thread_(startPool(kQueueLines)),
      logger_(std::make_shared<spdlog::async_logger>("log", sink_, thread_,
                                                     spdlog::async_overflow_policy::overrun_oldest)) {}

AsyncLineWriter::~AsyncLineWriter() {
  const std::future<void> flushed = sink_->flushed();
  logger_->flush();
  if (flushed.wait_for(kFlushTime) == std::future_status::timeout) sink_->discard();
  thread_.reset();  // joins
}

void AsyncLineWriter::write(std::string_view line) {
  logger_->log(spdlog::level::info, spdlog::string_view_t(line.data(), line.size()));
}

std::uint64_t AsyncLineWriter::takeDropped() {
  if (thread_->queue_size() > kQueueLines / 2) return 0;
  const std::uint64_t dropped = thread_->overrun_counter();
  return dropped - std::exchange(reportedDropped_, dropped);
}

}  // namespace platon
