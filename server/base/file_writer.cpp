#include "server/base/file_writer.h"

#include <signal.h>

#include <utility>

#include "server/base/text_file.h"

namespace platon {
namespace {

// Signals stay with the main thread, which they wake up.
void blockSignals() {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

FileWriter::~FileWriter() {
  if (writing_.valid()) writing_.wait();
  if (queued_) replaceTextFile(path_, *queued_);
}

void FileWriter::write(std::string content) {
  queued_ = std::move(content);
  pending_ = true;
  if (!writing_.valid()) start();
}

std::optional<std::string> FileWriter::poll() {
  if (!writing_.valid() || writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  const std::string fault = writing_.get();
  if (queued_) {
    start();
    return std::nullopt;
  }
  pending_ = !fault.empty();
  return pending_ ? std::optional(fault) : std::nullopt;
}

void FileWriter::start() {
  writing_ = std::async(std::launch::async, [path = path_, content = *std::exchange(queued_, std::nullopt)] {
    blockSignals();
    return replaceTextFile(path, content);
  });
}

}  // namespace platon
