#include "tests/sim/verify/verify_report.h"

#include <utility>

#include "protocol/program_error.h"
#include "protocol/texts.h"
#include "tests/sim/hex_digits.h"

namespace platon::sim {
namespace {

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

}  // namespace

std::string jsonOf(const Divergence& divergence) {
  std::string text = "{\"tick\":" + std::to_string(divergence.tick) + ",\"hash\":\"" + hexDigits(divergence.replayed) +
                     "\",\"recordedHash\":\"" + hexDigits(divergence.recorded) + "\"";
  if (divergence.comparedAt) text += ",\"comparedAt\":" + std::to_string(*divergence.comparedAt);
  if (divergence.difference) {
    const StateDifference& found = *divergence.difference;
    text += ",\"entity\":" + jsonText(found.owner) + ",\"field\":" + jsonText(found.field) +
            ",\"value\":" + jsonText(found.left) + ",\"recordedValue\":" + jsonText(found.right);
  }
  return text + "}";
}

std::string jsonOf(const std::variant<RunFinish, std::string>& run) {
  if (const auto* const fault = std::get_if<std::string>(&run)) return "\"run\":null,\"noRun\":" + jsonText(*fault);
  const RunFinish& finish = std::get<RunFinish>(run);
  return "\"run\":{\"player\":" + std::to_string(finish.slot) + ",\"ticks\":" + std::to_string(finish.ticks) + "}";
}

std::string textOf(const std::variant<RunFinish, std::string>& run) {
  if (const auto* const fault = std::get_if<std::string>(&run)) return *fault;
  const RunFinish& finish = std::get<RunFinish>(run);
  return "is a run of player " + std::to_string(finish.slot) + ": " + std::to_string(finish.ticks) + " ticks";
}

VerifyReport reportOf(const std::string& path, const Verification& found) {
  VerifyReport report{{}, found.divergence ? ProgramError::kFailed : found.fault.empty() ? 0 : ProgramError::kInvalid};
  if (found.divergence) report.text += path + ": " + sentenceOf(*found.divergence) + "\n";
  if (found.fault.empty()) return report;
  const bool agreed = !found.divergence && found.ticks != 0;
  report.text += path + ": " + found.fault;
  if (agreed) report.text += "; the " + std::to_string(found.ticks) + " ticks before agree";
  report.text += "\n";
  return report;
}

void VerifyProgress::tell(Time now, const std::function<std::string()>& line) {
  if (!show_ || now < due_) return;
  due_ = now + std::chrono::seconds(1);
  shown_ = true;
  show_(line());
}

void VerifyProgress::hide() {
  if (std::exchange(shown_, false)) show_("");
}

}  // namespace platon::sim
