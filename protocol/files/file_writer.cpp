#include "protocol/files/file_writer.h"

#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "protocol/files/blocked_signals.h"

namespace platon {
namespace {

constexpr const char* kSilence = "the disk does not answer";

}  // namespace

FileWriter::FileWriter(std::string path, Start start, Replace replace)
    : path_(std::move(path)), start_(std::move(start)), replace_(std::move(replace)) {}

FileWriter::~FileWriter() {
  if (!finished_) finish();
}

void FileWriter::write(std::string content) {
  content_ = std::move(content);
  queued_ = true;
  pending_ = true;
  finished_ = false;
  reported_.clear();
  retryAt_ = {};
}

std::optional<std::string> FileWriter::poll(Time now) {
  const std::string fault = check(now);
  if (fault.empty()) return std::nullopt;
  ++failures_;
  retryAt_ = answerBy_ = now + kRetryInterval;
  if (fault == reported_) return std::nullopt;
  return reported_ = fault;
}

// Takes a result, and starts the write that is due. Returns what has failed now, or an empty text.
std::string FileWriter::check(Time now) {
  if (writing_.valid()) {
    if (writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return now < answerBy_ ? "" : kSilence;
    if (std::string fault = takeResult(); !fault.empty()) return fault;
    retryAt_ = {};  // of its silence
  }
  if (!queued_ || now < retryAt_) return {};
  answerBy_ = now + kRetryInterval;
  return start();
}

// A write in progress may be one of an older content.
std::optional<std::string> FileWriter::finish(std::chrono::milliseconds limit) {
  finished_ = true;
  while (pending_) {
    std::string fault = writing_.valid() ? "" : start();
    if (fault.empty()) {
      if (writing_.wait_for(limit) != std::future_status::ready) return kSilence;
      fault = takeResult();
    }
    if (!fault.empty()) return fault;
  }
  return std::nullopt;
}

// The thread outlives the writer if the disk does not answer, so it has copies of all that it needs.
void FileWriter::startThread(std::function<void()> task) {
  const BlockedSignals blocked;
  std::thread(std::move(task)).detach();
}

// Returns why the write could not start, or an empty text.
std::string FileWriter::start() {
  const auto task = std::make_shared<std::packaged_task<std::string()>>(
      [path = path_, content = content_, replace = replace_] { return replace(path, content); });
  std::future<std::string> result = task->get_future();
  try {
    start_([task] { (*task)(); });
  } catch (const std::system_error& error) {
    return std::string("cannot start a thread: ") + error.what();
  }
  writing_ = std::move(result);
  queued_ = false;
  return {};
}

// Returns why the newest content could not be written, or an empty text; also if a newer one is queued meanwhile.
std::string FileWriter::takeResult() {
  std::string fault = writing_.get();
  if (queued_) return {};
  pending_ = queued_ = !fault.empty();
  return fault;
}

}  // namespace platon
