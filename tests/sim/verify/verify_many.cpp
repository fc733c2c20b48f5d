#include "tests/sim/verify/verify_many.h"

#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "protocol/files/text_file.h"
#include "tests/sim/files.h"
#include "tests/sim/sim_options.h"
#include "tests/sim/verify/verification.h"
#include "tests/sim/verify/verify_report.h"

namespace platon::sim {
namespace {

namespace fs = std::filesystem;

void addRecordingsIn(const fs::path& folder, std::vector<std::string>& recordings) {
  const std::size_t before = recordings.size();
  std::error_code error;
  for (fs::recursive_directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    std::error_code unreadable;
    if (file->path().extension() == ".recording" && file->is_regular_file(unreadable)) {
      recordings.push_back(file->path().string());
    }
  }
  if (error) throw UsageError("cannot read '" + folder.string() + "': " + error.message());
  if (recordings.size() == before) {
    throw UsageError("no file in '" + folder.string() + "' is named like a recording: NAME.recording");
  }
  std::sort(recordings.begin() + static_cast<std::ptrdiff_t>(before), recordings.end());
}

// Keeps servers from removing a file, and tells whether one is writing it.
class SharedLock {
 public:
  explicit SharedLock(const std::string& path) : file_(openToRead(path).file) {}

  bool refused() const { return file_ && flock(file_.number(), LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK; }

 private:
  Descriptor file_;
};

struct Result {
  VerifyReport report;
  std::uint32_t ticks = 0;
};

// Nothing for a recording that is skipped.
std::optional<Result> verifyOne(const std::string& path) {
  const SharedLock lock(path);
  if (lock.refused()) return std::nullopt;
  try {
    const auto bytes = readBytes(path, kMaxRecordingBytes);
    const Verification found = Verifier(bytes).run();
    return Result{reportOf(path, found), found.ticks};
  } catch (const UsageError& unreadable) {
    if (!fs::exists(path)) return std::nullopt;
    return Result{{std::string(unreadable.what()) + "\n", 3}, 0};
  }
}

// Hands out the recordings to threads, and counts and reports the results in their order.
class Verifying {
 public:
  Verifying(const std::vector<std::string>& recordings, const std::function<void(const std::string&)>& fault,
            const std::function<void(std::size_t)>& counted)
      : recordings_(recordings), fault_(fault), countedCall_(counted), results_(recordings.size()) {}

  void work() {
    for (std::optional<std::size_t> mine = take(); mine; mine = take()) done(*mine, verifyOne(recordings_[*mine]));
  }
  const VerifySummary& summary() const { return summary_; }

 private:
  struct Slot {
    bool done = false;
    std::optional<Result> result;
  };

  std::optional<std::size_t> take() {
    const std::lock_guard guard(mutex_);
    return next_ < recordings_.size() ? std::optional(next_++) : std::nullopt;
  }

  void done(std::size_t index, std::optional<Result> result) {
    const std::lock_guard guard(mutex_);
    results_[index] = {true, std::move(result)};
    for (; counted_ < results_.size() && results_[counted_].done; ++counted_) count(results_[counted_].result);
    countedCall_(++done_);
  }

  void count(std::optional<Result>& result) {
    if (!result) {
      ++summary_.skipped;
      return;
    }
    ++summary_.recordings;
    ++(result->report.exitCode == 0   ? summary_.agree
       : result->report.exitCode == 1 ? summary_.differ
                                      : summary_.invalid);
    summary_.ticks += result->ticks;
    if (!result->report.text.empty()) fault_(result->report.text);
    result.reset();
  }

  const std::vector<std::string>& recordings_;
  const std::function<void(const std::string&)>& fault_;
  const std::function<void(std::size_t)>& countedCall_;
  std::mutex mutex_;
  std::size_t next_ = 0;  // to be handed out
  std::size_t done_ = 0;
  std::size_t counted_ = 0;  // results before this one are in the summary
  std::vector<Slot> results_;
  VerifySummary summary_;
};

}  // namespace

bool isFolder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

std::vector<std::string> recordingsAmong(const std::vector<std::string>& paths) {
  std::vector<std::string> recordings;
  for (const std::string& path : paths) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw UsageError("cannot read '" + path + "': " + error.message());
    if (fs::is_directory(status)) {
      addRecordingsIn(path, recordings);
    } else {
      recordings.push_back(path);
    }
  }
  return recordings;
}

VerifySummary verifyMany(const std::vector<std::string>& recordings, unsigned jobs,
                         const std::function<void(const std::string&)>& fault,
                         const std::function<void(std::size_t)>& counted) {
  const auto begin = std::chrono::steady_clock::now();
  Verifying verifying(recordings, fault, counted);
  {
    std::vector<std::jthread> threads;
    for (unsigned thread = 1; thread < jobs; ++thread) threads.emplace_back([&] { verifying.work(); });
    verifying.work();
  }
  VerifySummary summary = verifying.summary();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  summary.jobs = jobs;
  return summary;
}

}  // namespace platon::sim
