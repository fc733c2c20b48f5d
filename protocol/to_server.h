#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/input.h"
#include "protocol/chat.h"
#include "protocol/limits.h"
#include "protocol/session_token.h"

namespace platon {

/// First message of a client. Reliable.
struct Hello {
  std::uint32_t rulesVersion = kRulesVersion;
  std::string name;                     ///< a label (`isLabel`); empty: the server chooses one
  std::optional<SessionToken> token{};  ///< resumes the players that joined with the same token
  std::vector<std::uint64_t> levels{};  ///< hashes of known levels; at most kMaxLevelsKnown

  friend bool operator==(const Hello&, const Hello&) = default;
};

/// Requests the text of a level that the server has named. Reliable.
struct LevelRequest {
  std::uint64_t hash = 0;

  friend bool operator==(const LevelRequest&, const LevelRequest&) = default;
};

/// All players of the client leave. Reliable.
struct Leave {
  friend bool operator==(const Leave&, const Leave&) = default;
};

/// The players wish that the round ends and the next level follows, or no longer wish it. Reliable.
struct Vote {
  std::uint32_t round = 0;  ///< a vote for another round has no effect
  bool next = false;

  friend bool operator==(const Vote&, const Vote&) = default;
};

/// Another player joins over this connection, gets another name, or leaves. The answer is `LocalSlots`. Reliable.
struct Companion {
  std::uint32_t local = 1;  ///< its local number, at least 1. The server refuses numbers from kMaxLocalPlayers on
  bool joins = true;        ///< otherwise it leaves
  std::string name{};       ///< as in Hello; empty if it leaves

  friend bool operator==(const Companion&, const Companion&) = default;
};

/// A player of this connection says this. Reliable.
struct LocalChat {
  std::uint32_t local = 0;  ///< its local number, below kMaxLocalPlayers
  Chat chat;

  friend bool operator==(const LocalChat&, const LocalChat&) = default;
};

/// Inputs of a companion in PlayerInputs.
struct CompanionInputs {
  std::uint32_t local = 1;    ///< its local number, 1 … kMaxLocalPlayers - 1
  std::uint32_t first = 0;    ///< tick of the first input; at least PlayerInputs::first
  std::vector<Input> inputs;  ///< as in PlayerInputs; at least one

  friend bool operator==(const CompanionInputs&, const CompanionInputs&) = default;
};

/// Progress of the client's confirmed game, and all inputs of its players that the server has not confirmed.
/// Unsequenced. Sent in the tick in which the input changes and in the two ticks after it, otherwise every fourth tick,
/// and every 80 ms while there are no inputs. The first one of a round tells the server that the client has the level
/// and starts.
struct PlayerInputs {
  std::uint32_t round = 0;
  std::uint8_t sync = 0;  ///< number of the last full state restored in this round; 0: the client started at tick 0
  std::uint32_t confirmed = 0;  ///< ticks of this round that the confirmed game has advanced
  std::uint32_t hash = 0;       ///< `shortHash` of the confirmed game
  std::uint32_t first = 0;      ///< tick of the first input; at least `confirmed`
  std::vector<Input> inputs;    ///< of consecutive ticks, each with kPresent; at most kMaxInputsPerMessage
  std::uint8_t sequence = 0;    ///< one more than in the last PlayerInputs, modulo 256
  std::vector<CompanionInputs> companions{};  ///< in rising order of local numbers, each once

  friend bool operator==(const PlayerInputs&, const PlayerInputs&) = default;
};

using ToServer = std::variant<Hello, LevelRequest, Leave, Vote, LocalChat, Companion, PlayerInputs>;

/// Decodes a message from a client. Returns nothing if it is malformed or a value is out of range.
std::optional<ToServer> decodeToServer(std::span<const std::uint8_t> bytes);

/// Encodes a message, whose values must be within the limits above.
std::vector<std::uint8_t> encode(const Hello& message);
std::vector<std::uint8_t> encode(const LevelRequest& message);
std::vector<std::uint8_t> encode(const Leave& message);
std::vector<std::uint8_t> encode(const Vote& message);
std::vector<std::uint8_t> encode(const LocalChat& message);
std::vector<std::uint8_t> encode(const Companion& message);
std::vector<std::uint8_t> encode(const PlayerInputs& message);

}  // namespace platon
