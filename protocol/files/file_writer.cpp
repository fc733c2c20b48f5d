#include "protocol/files/file_writer.h"

#include <utility>

namespace platon {
namespace {

constexpr const char* kSilence = "the disk does not answer";

}  // namespace

// `finish` waits, so the end does not.
FileWriter::FileWriter(std::string path, ThreadStart start, Replace replace)
    : path_(std::move(path)), replace_(std::move(replace)), writing_(std::move(start), std::chrono::milliseconds(0)) {}

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
  if (writing_.isPending()) {
    auto written = writing_.poll();
    if (!written) return now < answerBy_ ? "" : kSilence;
    if (std::string fault = faultOf(std::move(*written)); !fault.empty()) return fault;
    retryAt_ = {};  // of its silence
  }
  if (!queued_ || now < retryAt_) return {};
  answerBy_ = now + kRetryInterval;
  start();
  return {};
}

// A write in progress may be one of an older content.
std::optional<std::string> FileWriter::finish(std::chrono::milliseconds limit) {
  finished_ = true;
  while (pending_) {
    if (!writing_.isPending()) start();
    auto written = writing_.wait(limit);
    if (!written) return kSilence;
    if (std::string fault = faultOf(std::move(*written)); !fault.empty()) return fault;
  }
  writing_.finish(limit);  // of the thread, which has nothing more to do
  return std::nullopt;
}

void FileWriter::start() {
  writing_.add([path = path_, content = content_, replace = replace_](const std::stop_token&) {
    return replace(path, content);
  });
  queued_ = false;
}

// Returns why the newest content could not be written, or an empty text; also if a newer one is queued meanwhile.
std::string FileWriter::faultOf(JobResult<std::string> written) {
  if (queued_) return {};
  std::string fault = written.value ? std::move(*written.value) : std::move(written.fault);
  pending_ = queued_ = !fault.empty();
  return fault;
}

}  // namespace platon
