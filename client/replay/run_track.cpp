#include "client/replay/run_track.h"

#include <algorithm>
#include <variant>

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

}  // namespace platon
