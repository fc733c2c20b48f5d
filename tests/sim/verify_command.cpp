#include <chrono>
#include <cstdio>

#include "levels/tool/json_text.h"
#include "tests/sim/commands.h"
#include "tests/sim/files.h"
#include "tests/sim/hex_digits.h"
#include "tests/sim/recording_file.h"
#include "tests/sim/sim_options.h"
#include "tests/sim/verification.h"

namespace platon::sim {
namespace {

// Longest recording that is read: weeks of play by eight players.
constexpr std::size_t kMaxRecordingBytes = std::size_t{1} << 30;

std::string jsonOf(const Divergence& divergence) {
  std::string text = ",\"differs\":{\"tick\":" + std::to_string(divergence.tick) + ",\"hash\":\"" +
                     hexDigits(divergence.replayed) + "\",\"recordedHash\":\"" + hexDigits(divergence.recorded) + "\"";
  if (divergence.comparedAt) text += ",\"comparedAt\":" + std::to_string(*divergence.comparedAt);
  if (divergence.difference) {
    const StateDifference& found = *divergence.difference;
    text += ",\"entity\":" + jsonText(found.owner) + ",\"field\":" + jsonText(found.field) +
            ",\"value\":" + jsonText(found.left) + ",\"recordedValue\":" + jsonText(found.right);
  }
  return text + "}";
}

void printJson(const std::string& path, const Verification& found, double timesRealTime) {
  std::printf(
      "{\"recording\":%s,\"firstTick\":%u,\"ticks\":%u,\"players\":%u,\"hash\":\"%016llx\",\"complete\":%s,"
      "\"timesRealTime\":%.0f%s}\n",
      jsonText(path).c_str(), found.firstTick, found.ticks, found.slots, static_cast<unsigned long long>(found.hash),
      found.fault.empty() ? "true" : "false", timesRealTime, found.divergence ? jsonOf(*found.divergence).c_str() : "");
}

void printText(const std::string& path, const Verification& found, double timesRealTime) {
  std::printf("recording %s\nfirst tick %u\nticks %u\nplayers %u\nhash %016llx\n%.0f times real time\n", path.c_str(),
              found.firstTick, found.ticks, found.slots, static_cast<unsigned long long>(found.hash), timesRealTime);
}

std::string sentenceOf(const Divergence& divergence) {
  std::string text = "desync at tick " + std::to_string(divergence.tick) + ": hash " + hexDigits(divergence.replayed) +
                     " replayed, " + hexDigits(divergence.recorded) + " recorded; ";
  if (!divergence.comparedAt) return text + "the recording ends before the next checkpoint, so that no field is known";
  text += "at the checkpoint of tick " + std::to_string(*divergence.comparedAt) + ", ";
  if (!divergence.difference) return text + "no field differs";
  const StateDifference& found = *divergence.difference;
  return text + found.field + " of " + found.owner + " is the first field that differs: " + found.left + " replayed, " +
         found.right + " recorded";
}

// Prints what is wrong and returns the exit code: 1 for a divergence, else 3 for an incomplete recording.
int reportFaults(const std::string& path, const Verification& found) {
  if (found.divergence) std::fprintf(stderr, "%s: %s\n", path.c_str(), sentenceOf(*found.divergence).c_str());
  const std::string agree = found.ticks == 0 ? "" : "; the " + std::to_string(found.ticks) + " ticks before agree";
  if (!found.fault.empty()) {
    std::fprintf(stderr, "%s: %s%s\n", path.c_str(), found.fault.c_str(), found.divergence ? "" : agree.c_str());
  }
  return found.divergence ? 1 : found.fault.empty() ? 0 : 3;
}

}  // namespace

int verifyCommand(const std::vector<std::string>& arguments) {
  const Options options(arguments, {"from", "record", "checkpoint-every"}, {"json"});
  const std::string& path = options.onlyPositional("platon-sim verify needs one recording: platon-sim verify FILE");
  const auto from = static_cast<std::uint32_t>(options.number("from", 0, 0, ~std::uint32_t{0}));
  const auto bytes = readBytes(path, kMaxRecordingBytes);
  const auto begin = std::chrono::steady_clock::now();
  Verifier verifier(bytes, from);
  RecordingFile recording(options);
  if (verifier.game() != nullptr) recording.start(*verifier.game(), OutputFile::Mode::kCreateNew);
  const Verification found = verifier.run([&](auto inputs, const Game& game) { recording.tick(inputs, game); });
  if (verifier.game() != nullptr) recording.finish(*verifier.game());
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  const double timesRealTime = found.ticks / (kTicksPerSecond * spent.count());
  if (verifier.game() != nullptr) (options.has("json") ? printJson : printText)(path, found, timesRealTime);
  return reportFaults(path, found);
}

}  // namespace platon::sim
