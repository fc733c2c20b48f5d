#include "client/replay/run_track.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "client/replay/run_cutter.h"

namespace platon {

bool FaceVisits::enters(std::uint32_t face) {
  const std::uint32_t bit = std::uint32_t{1} << (face % 32);
  const bool isNew = seen_ != 0 && (seen_ & bit) == 0;
  seen_ |= bit;
  return isNew;
}

const Split* RunTrack::splitOf(std::uint32_t face) const {
  const auto found =
      std::find_if(splits.begin(), splits.end(), [face](const Split& each) { return each.face == face; });
  return found == splits.end() ? nullptr : &*found;
}

InterpolatedPlayer RunTrack::at(std::uint32_t passed, double fraction) const {
  if (passed == 0) return {};
  const std::uint32_t now = std::min(passed, ticks);
  return {places[passed > ticks ? now : now - 1], places[now], fraction};
}

std::optional<RunTrack> trackOf(const Replay& replay, const std::stop_token& stop) {
  const auto* const finish = std::get_if<RunFinish>(&replay.run());
  if (finish == nullptr) return std::nullopt;
  RunTrack track;
  track.ticks = finish->ticks;
  const std::uint32_t first = replay.ticks() - track.ticks;
  Game game = replay.gameAfter(first);
  FaceVisits visits;
  for (std::uint32_t ticks = 0; !stop.stop_requested(); ++ticks) {
    track.places.push_back(snapshotOf(game, finish->slot));
    const PlayerSnapshot& place = track.places.back();
    if (place.present && visits.enters(place.part)) track.splits.push_back({place.part, ticks});
    if (ticks == track.ticks) return track;
    game.advance(replay.inputsOf(first + ticks));
  }
  return std::nullopt;
}

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
