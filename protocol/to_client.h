#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/input.h"
#include "protocol/limits.h"

namespace platon {

/// Answer to Hello: the client plays `slot`. Reliable, like all that follow up to `ConfirmedTicks`.
struct Welcome {
  std::uint32_t slot = 0;  ///< below maxPlayers
  std::uint32_t round = 0;
  std::uint64_t levelHash = 0;                     ///< of the round's level text
  std::uint32_t maxPlayers = 0;                    ///< 1 … kMaxPlayers
  std::uint32_t ticksPerSecond = kTicksPerSecond;  ///< always kTicksPerSecond
  std::string serverName;                          ///< a clean label, perhaps empty

  friend bool operator==(const Welcome&, const Welcome&) = default;
};

enum class RefusalCode : std::uint32_t { kWrongProtocol = 1, kWrongRules = 2, kFull = 3, kOther = 255 };

/// Answer to Hello: the client cannot play. The connection ends after it.
struct Refused {
  RefusalCode code = RefusalCode::kOther;  ///< a code from a newer server reads as kOther
  std::string reason;                      ///< one clean sentence for the player

  friend bool operator==(const Refused&, const Refused&) = default;
};

/// A piece of a level text. Pieces come in order.
struct LevelChunk {
  std::uint64_t hash = 0;
  std::uint32_t total = 0;          ///< bytes of the whole, 1 … kMaxLevelBytes
  std::uint32_t offset = 0;         ///< offset + bytes <= total
  std::vector<std::uint8_t> bytes;  ///< 1 … kChunkBytes

  friend bool operator==(const LevelChunk&, const LevelChunk&) = default;
};

/// A piece of a full state (`FullState`). Pieces come in order; all fields but offset and bytes are the same in all.
struct StateChunk {
  std::uint32_t round = 0;
  std::uint32_t tick = 0;
  std::uint8_t sync = 0;    ///< at least 1
  std::uint32_t total = 0;  ///< 1 … kMaxStateBytes
  std::uint32_t offset = 0;
  std::vector<std::uint8_t> bytes;

  friend bool operator==(const StateChunk&, const StateChunk&) = default;
};

/// An empty name: nobody plays the slot any more.
struct RosterEntry {
  std::uint32_t slot = 0;
  std::string name;

  friend bool operator==(const RosterEntry&, const RosterEntry&) = default;
};

/// Who plays, as far as it has changed: for one that joins, all that are there.
struct Roster {
  std::vector<RosterEntry> entries;  ///< at most kMaxRosterEntries

  friend bool operator==(const Roster&, const Roster&) = default;
};

/// A new round begins at its tick 0 with nobody present.
struct RoundStart {
  std::uint32_t round = 0;
  std::uint64_t levelHash = 0;

  friend bool operator==(const RoundStart&, const RoundStart&) = default;
};

/// The round was over after `tick` ticks; the next one starts some seconds later, and its level may be asked for now.
struct RoundEnd {
  std::uint32_t round = 0;
  std::uint32_t tick = 0;
  std::uint64_t nextLevelHash = 0;

  friend bool operator==(const RoundEnd&, const RoundEnd&) = default;
};

enum class ByeCode : std::uint32_t { kServerStops = 1, kRemoved = 2, kOther = 255 };

/// The server ends the connection.
struct Bye {
  ByeCode code = ByeCode::kOther;  ///< a code from a newer server reads as kOther
  std::string reason;              ///< one clean sentence for the player

  friend bool operator==(const Bye&, const Bye&) = default;
};

/// From this tick on, until changed again, the slot's input is `input`.
struct InputChange {
  std::uint32_t tick = 0;
  std::uint32_t slot = 0;  ///< below kMaxPlayers
  Input input;             ///< no buttons without kPresent

  friend bool operator==(const InputChange&, const InputChange&) = default;
};

/// How early an input of the client came.
struct SlackReport {
  /// Of the oldest input in a message that the server had not heard of yet and that changed the buttons; when none
  /// did, of the newest input.
  std::uint32_t tick = 0;
  /// By how many ticks it came before it was needed: 0 for the very next tick, negative when too late. Within
  /// plus and minus kMaxSlack.
  std::int32_t slack = 0;

  friend bool operator==(const SlackReport&, const SlackReport&) = default;
};

/// What the server has heard of the client since its last message of ticks.
struct LinkReport {
  std::uint8_t sequence = 0;         ///< of the newest message of inputs
  std::uint8_t lostPercent = 0;      ///< of the last messages of inputs, 0 … 100
  std::optional<SlackReport> slack;  ///< the least; nothing when no input was new

  friend bool operator==(const LinkReport&, const LinkReport&) = default;
};

/// What the server decided for ticks from … from + count - 1: only what differs from the tick before. A client whose
/// confirmed game has advanced by c ticks, from <= c < from + count, skips the changes before c and applies the others
/// to the inputs it holds. Unsequenced, many a second; what the client has not acknowledged is repeated.
struct ConfirmedTicks {
  std::uint32_t round = 0;
  std::uint32_t from = 0;
  std::uint32_t count = 0;           ///< 1 … kMaxTicksPerMessage
  std::uint32_t hash = 0;            ///< `shortHash` of the game advanced by from + count ticks
  std::optional<LinkReport> line;    ///< nothing when nothing was heard of the client since the last message
  std::vector<InputChange> changes;  ///< by tick, then slot; at most kMaxChangesPerMessage
  std::uint8_t sequence = 0;         ///< one more than that of the last message of ticks to this client

  friend bool operator==(const ConfirmedTicks&, const ConfirmedTicks&) = default;
};

using ToClient =
    std::variant<Welcome, Refused, LevelChunk, StateChunk, Roster, RoundStart, RoundEnd, Bye, ConfirmedTicks>;

/// Reads a message from the server. Nothing when it is malformed or any value is outside its range.
std::optional<ToClient> decodeToClient(std::span<const std::uint8_t> bytes);

/// The values must be within the limits above.
std::vector<std::uint8_t> encode(const Welcome& message);
std::vector<std::uint8_t> encode(const Refused& message);
std::vector<std::uint8_t> encode(const LevelChunk& message);
std::vector<std::uint8_t> encode(const StateChunk& message);
std::vector<std::uint8_t> encode(const Roster& message);
std::vector<std::uint8_t> encode(const RoundStart& message);
std::vector<std::uint8_t> encode(const RoundEnd& message);
std::vector<std::uint8_t> encode(const Bye& message);
std::vector<std::uint8_t> encode(const ConfirmedTicks& message);

}  // namespace platon
