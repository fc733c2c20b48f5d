#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "platon/game/recorded_run.h"
#include "platon/game/recording_reader.h"

namespace platon {

/// Whether two levels are the same, also if somebody has made one that has the hash of the other.
inline bool isSameLevel(const Level& a, const Level& b) { return &a == &b || (a.hash == b.hash && a.text == b.text); }

/// What stands at the beginning of a recording, also of one by older rules.
struct RecordingHead {
  std::uint32_t rules = 0;             ///< version of the rules that it was recorded with
  std::shared_ptr<const Level> level;  ///< null if its text is not valid for this program
};

/// Reads the head from the first bytes of a recording; the rest is not looked at. Returns nothing if it is damaged or
/// cut off, or not that of a recording.
std::optional<RecordingHead> readRecordingHead(std::span<const std::uint8_t> bytes);

/// Says of a recording of other rules why it is not played, as the end of a sentence that begins with its name.
std::string otherRulesText(std::uint32_t rules);

/// Why a reader of this recording has stopped, as the end of a sentence that begins with the name of the file; empty at
/// the end of a complete recording.
std::string recordingFault(const RecordingReader& reader, std::span<const std::uint8_t> recording);

/// Says what is wrong with a recording, as the end of such a sentence.
std::string damagedText(const std::string& fault);

/// The game before the first block of a recording; nothing if the state of that is not valid on the level.
std::optional<Game> gameBefore(const RecordedBlock& first, const std::shared_ptr<const Level>& level);

/// What it costs to play a recording once: its ticks, times the players, times the segments near a player. Whoever made
/// the recording has chosen all three.
class PlayCost {
 public:
  /// Cost of a player and a tick without segments in reach. Each segment that may be in reach adds one. One unit is
  /// about 0.1 µs on the worst levels, and less on others.
  static constexpr std::uint64_t kBase = 10;
  /// Most that a recording may cost: as 16 players for six minutes on a level that is as crowded as a valid one can be,
  /// about 20 s. 256 players play a whole round for that where at most 31 segments are in reach.
  static constexpr std::uint64_t kMax =
      std::uint64_t{17} * 6 * 60 * kTicksPerSecond * (kBase + std::uint64_t{kMaxSegmentsInReach});

  /// `start`: the game before the first block.
  explicit PlayCost(const Game& start) : slots_(start.slots()), ofPlayer_(kBase + segmentsInReach(start.level())) {}

  /// Adds the next block: its ticks and slots. Returns whether all blocks together cost at most kMax.
  bool add(std::uint32_t ticks, std::uint32_t slots);

 private:
  std::uint32_t slots_;  // those of the game never become fewer
  std::uint64_t ofPlayer_;
  std::uint64_t sum_ = 0;
};

/// How much of a recording has been played, in per cent. One thread plays it, another one looks.
using ReplayProgress = std::atomic<std::uint32_t>;

/// A recording that has been read and played once from its start to its end: every hash and every checkpoint agreed
/// with the game of this program. Keeps states in between, from which each tick is reached soon.
class Replay {
 public:
  /// Most states that are kept, whatever the length of the recording.
  static constexpr std::uint32_t kMaxStates = 256;
  /// Fewest ticks between two of them.
  static constexpr std::uint32_t kMinInterval = 60;
  static constexpr const char* kTooLong =
      "takes too long to be played: it has too many ticks, players or segments; platon-sim "
      "verify can still check it";
  static constexpr const char* kStopped = "was not read to its end";
  static constexpr const char* kNoStart = "is a damaged recording: its first state is not valid on its level";
  /// Most bytes of a recording.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  /// The replay of a recording, or why there is none, as the end of a sentence that begins with the name of its file:
  /// it is damaged, cut off, costs too much, or was made by other rules. Ends with the present block or tick when it is
  /// asked to stop. `progress`: where to tell how far it is; null: nowhere.
  static std::variant<std::shared_ptr<const Replay>, std::string> read(std::span<const std::uint8_t> recording,
                                                                       const std::stop_token& stop = {},
                                                                       ReplayProgress* progress = nullptr);

  const std::shared_ptr<const Level>& level() const { return start_.sharedLevel(); }
  /// Number of recorded ticks.
  std::uint32_t ticks() const { return ticks_; }
  /// Inputs of a tick, by slot. tick < ticks().
  std::span<const Input> inputsOf(std::uint32_t tick) const;
  /// The run that it shows, or why it shows none, as the end of a sentence like that of `read`.
  const std::variant<RunFinish, std::string>& run() const { return run_; }
  /// The game after the first `tick` recorded ticks. tick ≤ ticks(). Advances at most by interval() ticks.
  Game gameAfter(std::uint32_t tick) const;
  /// Ticks between two states that are kept.
  std::uint32_t interval() const { return interval_; }

 private:
  explicit Replay(Game start) : start_(std::move(start)), cost_(start_) {}
  std::string readBlocks(RecordingReader& reader, RecordedBlock first, const std::stop_token& stop);
  std::string add(RecordedBlock block);
  std::string play(const std::stop_token& stop, ReplayProgress* progress);

  Game start_;
  PlayCost cost_;
  std::variant<RunFinish, std::string> run_;
  std::vector<RecordedBlock> blocks_;  // not empty; the last one has no ticks
  std::uint32_t ticks_ = 0;
  std::uint32_t interval_ = kMinInterval;
  std::vector<std::vector<std::uint8_t>> states_;  // after 0, interval_, 2 · interval_ … ticks
};

/// The content of a file that may be a recording, or why there is none, as the end of a sentence that begins with the
/// name of the file: it cannot be read, is too large, or is no file but a folder or a pipe, which might never end.
/// Reads a MiB at a time, and ends with the present one when it is asked to stop.
struct RecordingBytes {
  std::string content{};
  std::string fault{};  ///< empty: there is content

  std::span<const std::uint8_t> bytes() const;
};
RecordingBytes readRecordingBytes(const std::filesystem::path& file, const std::stop_token& stop = {});

/// Reads a recording from a file, or says in one sentence why it cannot be played. Stops as
/// readRecordingBytes and Replay::read do, and tells its progress as the latter.
std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const std::filesystem::path& file,
                                                                    const std::stop_token& stop = {},
                                                                    ReplayProgress* progress = nullptr);

/// Reads the head of a recording from a file. Nothing if it cannot be read, or was stopped.
std::optional<RecordingHead> readRecordingHeadOf(const std::filesystem::path& file, const std::stop_token& stop = {});

}  // namespace platon
