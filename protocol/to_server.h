#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/input.h"
#include "protocol/limits.h"
#include "protocol/session_token.h"

namespace platon {

/// First message of a client. Reliable.
struct Hello {
  std::uint32_t protocolVersion = kProtocolVersion;
  std::uint32_t rulesVersion = kRulesVersion;  ///< meaningful when the protocol version is ours
  std::string name;                            ///< a clean label (`isLabel`); empty: the server makes one up
  std::optional<SessionToken> token{};         ///< takes back the player that was greeted with the same
  std::vector<std::uint64_t> levels{};         ///< hashes of levels that need not be sent; at most kMaxLevelsKnown

  friend bool operator==(const Hello&, const Hello&) = default;
};

/// Asks for the text of a level that the server has named. Reliable.
struct LevelRequest {
  std::uint64_t hash = 0;

  friend bool operator==(const LevelRequest&, const LevelRequest&) = default;
};

/// The player goes. Reliable.
struct Leave {
  friend bool operator==(const Leave&, const Leave&) = default;
};

/// Where the client stands, and every input of its own that the server has not confirmed. Unsequenced, every tick or
/// two; the first one of a round tells the server that the client has the level and starts.
struct PlayerInputs {
  std::uint32_t round = 0;
  std::uint8_t sync = 0;        ///< of the last full state taken in this round; 0: started at tick 0 by itself
  std::uint32_t confirmed = 0;  ///< ticks by which the confirmed game has advanced in this round
  std::uint32_t hash = 0;       ///< `shortHash` of the confirmed game
  std::uint32_t first = 0;      ///< tick of the first input; at least `confirmed`
  std::vector<Input> inputs;    ///< of consecutive ticks, each with kPresent; at most kMaxInputsPerMessage
  std::uint8_t sequence = 0;    ///< one more than that of the last message of inputs

  friend bool operator==(const PlayerInputs&, const PlayerInputs&) = default;
};

using ToServer = std::variant<Hello, LevelRequest, Leave, PlayerInputs>;

/// Reads a message from a client. Nothing when it is malformed or any value is outside its range.
std::optional<ToServer> decodeToServer(std::span<const std::uint8_t> bytes);

/// The values must be within the limits above.
std::vector<std::uint8_t> encode(const Hello& message);
std::vector<std::uint8_t> encode(const LevelRequest& message);
std::vector<std::uint8_t> encode(const Leave& message);
std::vector<std::uint8_t> encode(const PlayerInputs& message);

}  // namespace platon
