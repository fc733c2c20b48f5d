#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>

#include "protocol/texts.h"
#include "tests/sim/commands.h"
#include "tests/sim/files.h"
#include "tests/sim/hex_digits.h"
#include "tests/sim/recording_file.h"
#include "tests/sim/sim_options.h"
#include "tests/sim/verify/verification.h"
#include "tests/sim/verify/verify_many.h"
#include "tests/sim/verify/verify_report.h"

namespace platon::sim {
namespace {

void printJson(const std::string& path, const Level& level, const Verification& found, double timesRealTime) {
  std::printf(
      "{\"recording\":%s,\"level\":\"%s\",\"title\":%s,\"firstTick\":%u,\"beginsInMidGame\":%s,\"ticks\":%u,"
      "\"players\":%u,\"hash\":\"%016llx\","
      "\"complete\":%s,%s,\"timesRealTime\":%.0f%s}\n",
      jsonText(path).c_str(), hexDigits(level.hash).c_str(), jsonText(level.title).c_str(), found.firstTick,
      found.beginsInMidGame ? "true" : "false", found.ticks, found.slots, static_cast<unsigned long long>(found.hash),
      found.fault.empty() ? "true" : "false", jsonOf(found.run).c_str(), timesRealTime,
      found.divergence ? (",\"differs\":" + jsonOf(*found.divergence)).c_str() : "");
}

void printText(const std::string& path, const Level& level, const Verification& found, double timesRealTime) {
  std::printf(
      "recording %s\nlevel %s%s\nfirst tick %u%s\nticks %u\nplayers %u\nhash %016llx\n%s\n%.0f times real time\n",
      path.c_str(), hexDigits(level.hash).c_str(), (level.title.empty() ? "" : " " + level.title).c_str(),
      found.firstTick, found.beginsInMidGame ? "\nbegins in mid-game" : "", found.ticks, found.slots,
      static_cast<unsigned long long>(found.hash), textOf(found.run).c_str(), timesRealTime);
}

void showLine(const std::string& line) { std::fprintf(stderr, "\r%-60s\r%s", "", line.c_str()); }

// On a terminal; elsewhere nobody sees it.
VerifyProgress progressOnTerminal() {
  const bool isSeen = isatty(STDERR_FILENO) != 0;
  return {isSeen ? showLine : VerifyProgress::Show(), std::chrono::steady_clock::now()};
}

Verification replay(Verifier& verifier, RecordingFile& recording) {
  VerifyProgress progress = progressOnTerminal();
  return verifier.run([&](auto inputs, const Game& game) {
    recording.tick(inputs, game);
    progress.tell(std::chrono::steady_clock::now(), [&] {
      return "replayed " + std::to_string(static_cast<int>(verifier.part() * 100)) + " %, to tick " +
             std::to_string(game.tick());
    });
  });
}

// One recording: says all about it.
int verifyFile(const std::string& path, const Options& options) {
  const auto from = static_cast<std::uint32_t>(options.number("from", 0, 0, ~std::uint32_t{0}));
  const auto bytes = readBytes(path, kMaxRecordingBytes);
  const auto begin = std::chrono::steady_clock::now();
  Verifier verifier(bytes, from);
  RecordingFile recording(options);
  if (verifier.game() != nullptr) recording.start(*verifier.game(), OutputFile::Mode::kCreateNew);
  const Verification found = replay(verifier, recording);
  if (verifier.game() != nullptr) recording.finish(*verifier.game());
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  const double timesRealTime = found.ticks / (kTicksPerSecond * spent.count());
  if (const Game* const game = verifier.game(); game != nullptr)
    (options.has("json") ? printJson : printText)(path, game->level(), found, timesRealTime);
  const VerifyReport report = reportOf(path, found);
  std::fputs(report.text.c_str(), stderr);
  return report.exitCode;
}

constexpr const char* kSummaryText =
    "recordings %ju\nagree %ju\ndiffer %ju\ninvalid %ju\nskipped %ju\nticks %ju\nseconds %.3f\njobs %u\n"
    "%.0f recordings an hour and job\n%.0f times real time a job\n";
constexpr const char* kSummaryJson =
    "{\"recordings\":%ju,\"agree\":%ju,\"differ\":%ju,\"invalid\":%ju,\"skipped\":%ju,\"ticks\":%ju,\"seconds\":%.3f,"
    "\"jobs\":%u,\"recordingsPerHourAndJob\":%.0f,\"timesRealTimePerJob\":%.0f}\n";

void printSummary(const VerifySummary& summary, const char* layout) {
  using Count = std::uintmax_t;
  std::printf(layout, Count{summary.recordings}, Count{summary.agree}, Count{summary.differ}, Count{summary.invalid},
              Count{summary.skipped}, Count{summary.ticks}, summary.seconds, summary.jobs, summary.recordingsPerHour(),
              summary.timesRealTime());
}

VerifySummary verifyWithProgress(const std::vector<std::string>& recordings, unsigned jobs) {
  VerifyProgress progress = progressOnTerminal();
  const auto counted = [&](std::size_t done) {
    progress.tell(std::chrono::steady_clock::now(), [&] {
      return "replayed " + std::to_string(done) + " of " + std::to_string(recordings.size()) + " recordings";
    });
  };
  const auto tellFault = [&](const std::string& fault) {
    progress.hide();
    std::fputs(fault.c_str(), stderr);
  };
  return verifyMany(recordings, jobs, tellFault, counted);
}

// Recordings and folders of them: says how many agree, and what is wrong with the others.
int verifyAll(const Options& options) {
  for (const char* const ofOne : {"from", "record", "checkpoint-every"}) {
    if (options.has(ofOne)) throw UsageError(std::string("--") + ofOne + " works only with one recording");
  }
  const auto jobs = static_cast<unsigned>(options.number("jobs", 1, 1, kMaxJobs));
  const std::vector<std::string> recordings = recordingsAmong(options.positionals());
  const VerifySummary summary = verifyWithProgress(recordings, jobs);
  printSummary(summary, options.has("json") ? kSummaryJson : kSummaryText);
  return summary.exitCode();
}

}  // namespace

int verifyCommand(const std::vector<std::string>& arguments) {
  const Options options(arguments, {"from", "record", "checkpoint-every", "jobs"}, {"json"});
  const std::vector<std::string>& paths = options.positionals();
  if (paths.empty()) throw UsageError("platon-sim verify needs recordings: platon-sim verify FILE or FOLDER");
  const bool one = paths.size() == 1 && !options.has("jobs") && !isFolder(paths.front());
  return one ? verifyFile(paths.front(), options) : verifyAll(options);
}

}  // namespace platon::sim
