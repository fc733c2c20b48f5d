#include <algorithm>

#include "server/times/best_times.h"
#include "tests/fuzz/error_faults.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

const DatedTime kTime{{100, "Ann"}, UtcTime(std::chrono::hours(500'000))};

bool isReadAgain(const BestTimes& times) {
  const std::string text = times.text();
  const auto again = BestTimes::parse(text);
  return text.size() <= BestTimes::kMaxBytes && std::holds_alternative<BestTimes>(again) &&
         std::get<BestTimes>(again) == times;
}

std::string changeFault(BestTimes times) {
  const PlayedLevel level{0x0123456789abcdef, 6};
  const DatedTime* const before = times.find(level);
  const bool isLess = before == nullptr || kTime.time.ticks < before->time.ticks;
  BestTimes merged = times;
  BestTimes other;
  other.offer(level, kTime);
  merged.merge(other);
  if (times.offer(level, kTime) != isLess) return "a time that is no less was taken, or a lesser one was not";
  if (!(merged == times)) return "merging differs from offering";
  const DatedTime* const after = times.find(level);
  if (after == nullptr || after->time.ticks > kTime.time.ticks) return "the lesser time is not kept";
  return isReadAgain(times) ? std::string() : "changed times are not read again";
}

}  // namespace

std::string bestTimesFault(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const auto parsed = BestTimes::parse(text);
  if (const auto* errors = std::get_if<std::vector<Diagnostic>>(&parsed))
    return errorsFault(*errors, BestTimes::kMaxErrors, text);
  const auto& times = std::get<BestTimes>(parsed);
  return isReadAgain(times) ? changeFault(times) : "times are not read again";
}

}  // namespace platon::fuzz
