#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/input.h"
#include "protocol/chat.h"
#include "protocol/limits.h"

namespace platon {

/// Answer to Hello: the client plays `slot`. Reliable, like all messages below except `RoundTrips` and
/// `ConfirmedTicks`.
struct Welcome {
  std::uint32_t slot = 0;  ///< below maxPlayers
  std::uint32_t round = 0;
  std::uint64_t levelHash = 0;                     ///< of the text of the round's level
  std::uint32_t maxPlayers = 0;                    ///< 1 … kMaxPlayers
  std::uint32_t ticksPerSecond = kTicksPerSecond;  ///< always kTicksPerSecond
  std::string serverName;                          ///< a label, perhaps empty

  friend bool operator==(const Welcome&, const Welcome&) = default;
};

enum class RefusalCode : std::uint32_t { kWrongRules = 2, kFull = 3, kOther = 255 };

/// Answer to Hello: the client cannot play. The connection closes after it.
struct Refused {
  RefusalCode code = RefusalCode::kOther;  ///< a code from a newer server reads as kOther
  std::string reason;                      ///< one sentence for the player, a label
  std::string next{};                      ///< as in Bye: a server to join instead

  friend bool operator==(const Refused&, const Refused&) = default;
};

/// A part of a level text. Chunks arrive in order.
struct LevelChunk {
  std::uint64_t hash = 0;
  std::uint32_t total = 0;          ///< bytes of the whole text, 1 … kMaxLevelBytes
  std::uint32_t offset = 0;         ///< offset + bytes <= total
  std::vector<std::uint8_t> bytes;  ///< 1 … kChunkBytes

  friend bool operator==(const LevelChunk&, const LevelChunk&) = default;
};

/// A part of an encoded `FullState`. Chunks arrive in order; only offset and bytes differ between them.
struct StateChunk {
  std::uint32_t round = 0;
  std::uint32_t tick = 0;
  std::uint8_t sync = 0;    ///< number of this full state in the round; at least 1
  std::uint32_t total = 0;  ///< bytes of the whole state, 1 … kMaxStateBytes
  std::uint32_t offset = 0;
  std::vector<std::uint8_t> bytes;

  friend bool operator==(const StateChunk&, const StateChunk&) = default;
};

/// Name of the player in a slot. An empty name: the player has left.
struct RosterEntry {
  std::uint32_t slot = 0;
  std::string name;

  friend bool operator==(const RosterEntry&, const RosterEntry&) = default;
};

/// Changed names of the players. A client that joins receives all of them.
struct Roster {
  std::vector<RosterEntry> entries;  ///< at most kMaxRosterEntries

  friend bool operator==(const Roster&, const Roster&) = default;
};

/// A new round starts at tick 0 with no player present.
struct RoundStart {
  std::uint32_t round = 0;
  std::uint64_t levelHash = 0;

  friend bool operator==(const RoundStart&, const RoundStart&) = default;
};

/// The shortest time in which a player has reached the goal of a level.
struct LevelBest {
  std::uint32_t ticks = 0;  ///< 1 … kMaxBestTicks
  std::string name;         ///< of the player, a label of at most kMaxNameBytes
  bool isNew = false;       ///< reached in this round

  friend bool operator==(const LevelBest&, const LevelBest&) = default;
};

/// The round ended after `tick` ticks. The next one starts after `pauseTicks` more; its level may be requested now.
/// Another RoundEnd of the same round replaces this one: the next level or the best time has changed.
struct RoundEnd {
  std::uint32_t round = 0;
  std::uint32_t tick = 0;
  std::uint64_t nextLevelHash = 0;
  std::string nextTitle{};          ///< of the next level, a label of at most kMaxTitleBytes
  std::uint32_t pauseTicks = 0;     ///< at most kMaxPauseTicks; 0: until the player asks for it
  std::optional<LevelBest> best{};  ///< of the level of this round; nothing: nobody has reached its goal

  friend bool operator==(const RoundEnd&, const RoundEnd&) = default;
};

enum class ByeCode : std::uint32_t { kServerStops = 1, kRemoved = 2, kOther = 255 };

/// The server closes the connection.
struct Bye {
  ByeCode code = ByeCode::kOther;  ///< a code from a newer server reads as kOther
  std::string reason;              ///< one sentence for the player, a label
  std::string next{};              ///< a label of at most kMaxNextServerBytes: if it is an address, as isNextServer
                                   ///< tells, the player can go on there

  friend bool operator==(const Bye&, const Bye&) = default;
};

/// A text of the server's operator for the players. It is shown for some seconds; a newer one replaces it.
struct Notice {
  std::string text;  ///< a label of at most kMaxReasonBytes

  friend bool operator==(const Notice&, const Notice&) = default;
};

/// How many players wish the next level. It follows when they are more than half of the voters.
struct VoteCount {
  std::uint32_t round = 0;
  std::uint32_t votes = 0;   ///< at most `voters`
  std::uint32_t voters = 0;  ///< at most kMaxPlayers

  friend bool operator==(const VoteCount&, const VoteCount&) = default;
};

/// A player says this.
struct PlayerChat {
  std::uint32_t slot = 0;  ///< below kMaxPlayers
  Chat chat;

  friend bool operator==(const PlayerChat&, const PlayerChat&) = default;
};

/// Slots by local number; nothing for a local number without a player.
using SlotsByLocal = std::array<std::optional<std::uint32_t>, kMaxLocalPlayers>;

/// The slots of the players of this client. Answers a `Companion`, and is sent when a player has been removed. After
/// `Welcome`, only the player of `Hello` has a slot, unless this follows at once, as it does when a client resumes
/// several players.
struct LocalSlots {
  SlotsByLocal slots;    ///< below kMaxPlayers, each once; of local number 0 always
  std::string reason{};  ///< why a player does not have one, a sentence for the players, a label; empty: as they wished
  std::uint32_t local = 0;  ///< that of the `Companion` which this answers; 0: of none

  friend bool operator==(const LocalSlots&, const LocalSlots&) = default;
};

/// The round trip between the server and a player in one byte: kNoRoundTrip for none, else one more than the number of
/// kRoundTripStepMs, rounded. The highest code stands for every longer one.
inline constexpr std::uint8_t kNoRoundTrip = 0;
inline constexpr std::uint32_t kRoundTripStepMs = 4;
inline constexpr std::uint32_t kMaxRoundTripMs = 254 * kRoundTripStepMs;

constexpr std::uint8_t codeOfRoundTrip(std::uint32_t ms) {
  const std::uint32_t steps = (std::min(ms, kMaxRoundTripMs) + kRoundTripStepMs / 2) / kRoundTripStepMs;
  return static_cast<std::uint8_t>(1 + steps);
}

/// Milliseconds, at most kMaxRoundTripMs.
constexpr std::optional<std::uint32_t> roundTripOf(std::uint8_t code) {
  return code == kNoRoundTrip ? std::nullopt : std::optional((code - 1U) * kRoundTripStepMs);
}

/// The round trips between the server and the connected players. Unsequenced; about one every two seconds.
struct RoundTrips {
  std::vector<std::uint8_t> codes;  ///< by slot, as codeOfRoundTrip; at most kMaxPlayers

  friend bool operator==(const RoundTrips&, const RoundTrips&) = default;
};

/// Input of a slot from `tick` on, until the slot's next change.
struct InputChange {
  std::uint32_t tick = 0;
  std::uint32_t slot = 0;  ///< below kMaxPlayers
  Input input;             ///< no buttons without kPresent

  friend bool operator==(const InputChange&, const InputChange&) = default;
};

/// How early an input of the client arrived.
struct SlackReport {
  /// Tick of the measured input: the oldest input in the message that was new to the server and changed the buttons, or
  /// the newest input when none did.
  std::uint32_t tick = 0;
  /// Ticks that the input arrived before it was needed: 0 for the next tick to decide, negative when it was too late.
  /// Within plus or minus kMaxSlack.
  std::int32_t slack = 0;

  friend bool operator==(const SlackReport&, const SlackReport&) = default;
};

/// Link statistics measured by the server on the messages of this client.
struct LinkReport {
  std::uint8_t sequence = 0;         ///< of the newest PlayerInputs received
  std::uint8_t lostPercent = 0;      ///< of the last messages of inputs; 0 … 100
  std::optional<SlackReport> slack;  ///< the smallest since the last report; nothing if no input was new

  friend bool operator==(const LinkReport&, const LinkReport&) = default;
};

/// Inputs that the server decided for ticks from … from + count - 1, as changes from tick to tick. A client whose
/// confirmed game has advanced by c ticks, from <= c < from + count, skips the changes before c and applies the others
/// to its current inputs. Unsequenced, up to 60 a second; ticks that the client has not acknowledged are repeated.
struct ConfirmedTicks {
  std::uint32_t round = 0;
  std::uint32_t from = 0;
  std::uint32_t count = 0;           ///< 1 … kMaxTicksPerMessage
  std::uint32_t hash = 0;            ///< `shortHash` of the game advanced by from + count ticks
  std::optional<LinkReport> link;    ///< nothing if no PlayerInputs has arrived since the last message
  std::vector<InputChange> changes;  ///< ordered by tick, then slot; at most kMaxChangesPerMessage
  std::uint8_t sequence = 0;         ///< one more than in the last ConfirmedTicks to this client, modulo 256

  friend bool operator==(const ConfirmedTicks&, const ConfirmedTicks&) = default;
};

using ToClient = std::variant<Welcome, Refused, LevelChunk, StateChunk, Roster, RoundStart, RoundEnd, Bye, Notice,
                              VoteCount, PlayerChat, RoundTrips, LocalSlots, ConfirmedTicks>;

/// Decodes a message from the server. Returns nothing if it is malformed or a value is out of range.
std::optional<ToClient> decodeToClient(std::span<const std::uint8_t> bytes);

/// Encodes a message, whose values must be within the limits above.
std::vector<std::uint8_t> encode(const Welcome& message);
std::vector<std::uint8_t> encode(const Refused& message);
std::vector<std::uint8_t> encode(const LevelChunk& message);
std::vector<std::uint8_t> encode(const StateChunk& message);
std::vector<std::uint8_t> encode(const Roster& message);
std::vector<std::uint8_t> encode(const RoundStart& message);
std::vector<std::uint8_t> encode(const RoundEnd& message);
std::vector<std::uint8_t> encode(const Bye& message);
std::vector<std::uint8_t> encode(const Notice& message);
std::vector<std::uint8_t> encode(const VoteCount& message);
std::vector<std::uint8_t> encode(const PlayerChat& message);
std::vector<std::uint8_t> encode(const RoundTrips& message);
std::vector<std::uint8_t> encode(const LocalSlots& message);
std::vector<std::uint8_t> encode(const ConfirmedTicks& message);

}  // namespace platon
