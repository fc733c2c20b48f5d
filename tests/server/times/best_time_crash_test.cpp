// What a crash of the server leaves of the file of best times.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <new>

#include "server/times/best_times.h"
#include "tests/support/environment_variable.h"
#include "tests/support/run/repetitions.h"
#include "tests/support/temporary_folder.h"

namespace platon::best_time_crash_test {
namespace {

const UtcTime kDate = *parseUtcTime("2026-12-01T18:00:00Z");

BestTimes timesIn(const std::string& path) {
  auto read = readBestTimes(path);
  const auto* errors = std::get_if<std::vector<std::string>>(&read);
  EXPECT_EQ(errors, nullptr) << errors->front();
  return errors ? BestTimes() : std::get<BestTimes>(std::move(read));
}

/// A process that adds better and better times to a file until it is killed.
class KilledWriter {
 public:
  explicit KilledWriter(const std::string& path) : path_(path), writes_(shared()) {}
  ~KilledWriter() { munmap(writes_, sizeof(*writes_)); }
  KilledWriter(const KilledWriter&) = delete;
  KilledWriter& operator=(const KilledWriter&) = delete;

  /// Lets it write for so long and kills it.
  void run(std::chrono::microseconds time) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) write();
    usleep(static_cast<useconds_t>(time.count()));
    kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
  }
  /// Writes that have ended, and the last of them.
  std::uint32_t writes() const { return *writes_; }

 private:
  static std::atomic<std::uint32_t>* shared() {
    void* const memory =
        mmap(nullptr, sizeof(std::uint32_t), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    return new (memory) std::atomic<std::uint32_t>(0);
  }

  // Rules whose ticks have no bound.
  [[noreturn]] void write() {
    for (;;) {
      BestTimes times;
      times.offer({*writes_ % 50, 0}, {{UINT32_MAX - *writes_, "Ann"}, kDate});
      if (addBestTimes(path_, times.text()).empty()) ++*writes_;
    }
  }

  std::string path_;
  std::atomic<std::uint32_t>* writes_;
};

// Kills a process while it writes, again and again, until it has written 10 000 times. In memory where that is
// possible: a kill does not depend on the disk, which would take minutes.
TEST(BestTimeCrash, AFileIsWholeWheneverItsWriterIsKilled) {
  constexpr const char* kMemory = "/dev/shm";
  const std::filesystem::path disk = std::filesystem::temp_directory_path();
  const bool hasMemory = access(kMemory, W_OK) == 0;
  const EnvironmentVariable temporary("TMPDIR", hasMemory ? std::string(kMemory) : disk.string());
  const TemporaryFolder folder;
  const std::string path = folder / "best_times";
  KilledWriter writer(path);
  std::uint64_t kills = 0;
  for (std::uint32_t time = 1; writer.writes() < repetitions(10'000u); time = time * 13 % 5'003) {
    ASSERT_NO_FATAL_FAILURE(writer.run(std::chrono::microseconds(500 + time)));
    ++kills;
    if (writer.writes() == 0) continue;
    const std::uint32_t last = writer.writes() - 1;
    const BestTimes times = timesIn(path);
    const DatedTime* const found = times.find({last % 50, 0});
    ASSERT_TRUE(found) << "after " << writer.writes() << " writes";
    ASSERT_LE(found->time.ticks, UINT32_MAX - last);
  }
  EXPECT_GT(kills, repetitions(100u));
}

}  // namespace
}  // namespace platon::best_time_crash_test
