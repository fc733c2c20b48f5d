#pragma once

#include <cstddef>
#include <cstdint>

#include "platon/game/game.h"
#include "platon/game/input.h"
#include "platon/game/level.h"

namespace platon {

/// Version of the messages; both sides must have the same. docs/architecture.md#versions says when it is raised.
inline constexpr std::uint32_t kProtocolVersion = 5;
inline constexpr std::uint16_t kDefaultPort = 7777;

/// Channels of the transport. All reliable messages share one, so that they arrive in the order in which they were
/// sent.
inline constexpr std::uint8_t kReliableChannel = 0;
inline constexpr std::uint8_t kTickChannel = 1;
inline constexpr std::size_t kChannels = 2;

/// Longest message, bytes: with all headers its datagram stays within 1200 bytes, so none is ever split.
inline constexpr std::size_t kMaxMessageBytes = 1152;
/// Bytes of a level text or a full state in one message.
inline constexpr std::size_t kChunkBytes = 1024;

/// Longest full state, bytes.
inline constexpr std::size_t kMaxStateBytes = 1024 * 1024;
/// Levels that a client may list in `Hello` as known.
inline constexpr std::size_t kMaxLevelsKnown = 8;
/// Names in one `Roster`. With the longest names the message is below `kMaxMessageBytes`.
inline constexpr std::size_t kMaxRosterEntries = 16;
/// Longest name of a player or a server, and longest reason shown to a player, bytes of UTF-8.
inline constexpr std::size_t kMaxNameBytes = 32;
inline constexpr std::size_t kMaxReasonBytes = 200;

/// Longest address of another server that a server tells its players, bytes.
inline constexpr std::size_t kMaxNextServerBytes = 128;

/// Longest text of a player for the others, bytes of UTF-8.
inline constexpr std::size_t kMaxChatBytes = 120;
/// Number of emotes. An emote is a number from 1 on.
inline constexpr std::uint32_t kEmotes = 4;

/// Longest title of a level, bytes of UTF-8: as in the level format.
inline constexpr std::size_t kMaxTitleBytes = 100;
/// Longest pause between two rounds: a minute.
inline constexpr std::uint32_t kMaxPauseTicks = 60 * kTicksPerSecond;
/// Longest time to a goal that counts as a best time: a day. A round of a player who is alone may have no time limit.
inline constexpr std::uint32_t kMaxBestTicks = 24 * 60 * 60 * kTicksPerSecond;

/// Players who may share a connection, each in a slot of its own. Their *local numbers* are 0 … kMaxLocalPlayers - 1: 0
/// is the player of `Hello`, the others are its companions.
inline constexpr std::uint32_t kMaxLocalPlayers = 4;

/// Inputs of one player in one message of a client: enough for a round trip of 2 s and a buffer of 1 s. With those of
/// kMaxLocalPlayers, none of which equals the one before, the message is below kMaxMessageBytes.
inline constexpr std::uint32_t kMaxInputsPerMessage = 256;
/// Ticks and input changes in one message of the server. Every single tick fits, and the longest message is below
/// `kMaxMessageBytes`: a change takes two bytes, or three when at least three ticks lie between it and the last
/// one.
inline constexpr std::uint32_t kMaxTicksPerMessage = 240;
inline constexpr std::uint32_t kMaxChangesPerMessage = 512;
/// Slack is clamped to plus or minus this, ticks.
inline constexpr std::int32_t kMaxSlack = 1000;

/// Part of a state hash that is sent in per-tick messages. A desync that it misses in one tick shows in a later one.
constexpr std::uint32_t shortHash(std::uint64_t hash) { return static_cast<std::uint32_t>(hash); }

}  // namespace platon
