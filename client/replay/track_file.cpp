#include "client/replay/track_file.h"

#include <memory>
#include <utility>

#include "client/replay/replay_file.h"
#include "client/replay/run_cutter.h"
#include "client/replay/same_level.h"

namespace platon {
namespace {

static_assert(RunCutter::kMaxTicks == 30 * 60 * kTicksPerSecond, "mend the text");
constexpr const char* kTooLongRun = "is a run of more than 30 minutes, too long for a ghost";

}  // namespace

std::variant<RunTrack, std::string> readTrack(const std::filesystem::path& file, const Level* level,
                                              const std::stop_token& stop) {
  const auto read = readReplay(file, stop);
  if (const auto* fault = std::get_if<std::string>(&read)) return *fault;
  const Replay& replay = *std::get<std::shared_ptr<const Replay>>(read);
  if (level != nullptr && !isSameLevel(*replay.level(), *level))
    return file.string() + ": is a recording of another level";
  const auto* const finish = std::get_if<RunFinish>(&replay.run());
  if (finish != nullptr && finish->ticks > RunCutter::kMaxTicks) return file.string() + ": " + kTooLongRun;
  std::optional<RunTrack> track = trackOf(replay, stop);
  if (stop.stop_requested()) return file.string() + ": " + Replay::kStopped;
  if (!track) return file.string() + ": " + std::get<std::string>(replay.run());
  return std::move(*track);
}

std::optional<RunTrack> trackIn(std::span<const std::uint8_t> recording, const std::stop_token& stop) {
  const auto read = Replay::read(recording, stop);
  const auto* const replay = std::get_if<std::shared_ptr<const Replay>>(&read);
  return replay == nullptr ? std::nullopt : trackOf(**replay, stop);
}

}  // namespace platon
