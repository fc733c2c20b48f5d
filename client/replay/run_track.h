#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "client/netcode/player_snapshot.h"
#include "client/replay/replay.h"

namespace platon {

/// The moment at which a run enters a face for the first time.
struct Split {
  std::uint32_t face = 0;
  std::uint32_t ticks = 0;  ///< of the attempt

  friend bool operator==(const Split&, const Split&) = default;
};

/// Notices when an attempt enters a face that it has not been on. Its first face is none of them.
class FaceVisits {
 public:
  /// Whether the player enters a new face now. `face` is below 32.
  bool enters(std::uint32_t face);

 private:
  std::uint32_t seen_ = 0;  // bits
};

/// Where the player of a run was in every tick, and the splits. The run of a recording is that of the player who
/// touches the goal in its last tick; of several, of the one in the first slot.
struct RunTrack {
  std::uint32_t ticks = 0;             ///< time of the attempt, as the game counts it
  std::vector<PlayerSnapshot> places;  ///< after so many ticks of the attempt: 0 … ticks
  std::vector<Split> splits;           ///< in order

  /// The split of a face; null if the run did not enter it, or began there.
  const Split* splitOf(std::uint32_t face) const;
  /// The player `fraction` of a tick after `ticks` − 1 ticks of the attempt: not present before the first tick, at the
  /// goal after the last.
  InterpolatedPlayer at(std::uint32_t ticks, double fraction) const;
};

/// Nothing if the replay is no run (see Replay::run), or if it was asked to stop, which it looks at in each tick.
std::optional<RunTrack> trackOf(const Replay& replay, const std::stop_token& stop = {});

/// Reads the run of a recording from a file, and plays it once, or says in one sentence why it is none, or longer than
/// RunCutter::kMaxTicks, which bounds the memory for its places. `level`: that it must be on; null: any. Stops as
/// readReplay and trackOf do.
std::variant<RunTrack, std::string> readTrack(const std::filesystem::path& file, const Level* level = nullptr,
                                              const std::stop_token& stop = {});

/// The run of a recording that this program has made. Nothing if it is none, or was stopped.
std::optional<RunTrack> trackIn(std::span<const std::uint8_t> recording, const std::stop_token& stop = {});

}  // namespace platon
