#include "server/program/descriptor_sink.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>
#include <string>

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

}  // namespace platon
