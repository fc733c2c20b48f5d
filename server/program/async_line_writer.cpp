#include "server/program/async_line_writer.h"

#include <spdlog/async_logger.h>
#include <spdlog/details/thread_pool.h>

#include <future>
#include <utility>

#include "protocol/work/blocked_signals.h"
#include "server/program/descriptor_sink.h"

namespace platon {
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
