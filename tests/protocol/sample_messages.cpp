#include "tests/protocol/sample_messages.h"

namespace platon {
namespace {

constexpr SessionToken kToken = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 255};

PlayerInputs manyInputs() {
  PlayerInputs message{70000, 255, 1234567, 0xfedcba98, 1234570, {}};
  for (std::uint32_t i = 0; i < kMaxInputsPerMessage; ++i) message.inputs.push_back(pressing(i % 20 < 15 ? 1 : 20));
  return message;
}

// Of as many players, and as long, as there can be.
PlayerInputs manyInputsOfAll() {
  PlayerInputs message{UINT32_MAX, 255, UINT32_MAX - 600, 0xfedcba98, UINT32_MAX - 300, {}, 255};
  for (std::uint32_t i = 0; i < kMaxInputsPerMessage; ++i) message.inputs.push_back(pressing(i % 2 == 0 ? 0 : 1));
  for (std::uint32_t local = 1; local < kMaxLocalPlayers; ++local)
    message.companions.push_back({local, UINT32_MAX - 256, message.inputs});
  return message;
}

ConfirmedTicks manyChanges() {
  ConfirmedTicks message{
      UINT32_MAX, UINT32_MAX - kMaxTicksPerMessage, kMaxTicksPerMessage, 1, LinkReport{255, 100, SlackReport{0, -1000}},
      {}};
  for (std::uint32_t i = 0; i < kMaxChangesPerMessage; ++i) {
    const std::uint32_t tick = message.from + (i / 256 * (kMaxTicksPerMessage - 1));
    message.changes.push_back(
        {tick, i % 256, i % 2 == 0 ? Input{} : pressing(Input::kLeft | Input::kWalk | Input::kJump)});
  }
  return message;
}

}  // namespace

std::vector<ToServer> sampleToServer() {
  return {
      Hello{kRulesVersion, "Ann"},
      Hello{99, ""},
      Hello{kRulesVersion, "Ben", kToken},
      Hello{kRulesVersion, "", kToken, {1, 0, UINT64_MAX, 4, 5, 6, 7, 8}},
      Hello{kRulesVersion, "Łukasz Żółć 世界 32 bytes"},
      LevelRequest{0x0123456789abcdef},
      LevelRequest{0},
      Leave{},
      Vote{},
      Vote{7, true},
      Vote{UINT32_MAX, false},
      LocalChat{0, {"Wait for me at the plate", 0}},
      LocalChat{0, {std::string(kMaxChatBytes, 'x'), 0}},
      LocalChat{kMaxLocalPlayers - 1, {"", kEmotes}},
      Companion{},
      Companion{kMaxLocalPlayers - 1, true, "Łukasz Żółć 世界 32 bytes"},
      Companion{2, false},
      Companion{255, true, "Ann"},
      PlayerInputs{},
      PlayerInputs{1, 0, 0, 0, 0, {pressing(0)}},
      PlayerInputs{1, 2, 300, 0x01020304, 302, {pressing(2), pressing(2), pressing(6), pressing(0)}, 201},
      PlayerInputs{9, 1, UINT32_MAX - 8, 7, UINT32_MAX - 8, std::vector<Input>(8, pressing(8))},
      PlayerInputs{1, 0, 5, 0, 7, {pressing(1)}, 0, {{3, 9, {pressing(2), pressing(2)}}}},
      PlayerInputs{1, 0, 5, 0, 5, {}, 0, {{1, 5, {pressing(0)}}, {2, 1 << 20, std::vector<Input>(256, pressing(1))}}},
      manyInputs(),
      manyInputsOfAll()};
}

std::vector<ToClient> sampleToClient() {
  return {Welcome{3, 7, 0x0123456789abcdef, 16, kTicksPerSecond, "Platon"},
          Welcome{255, 1, 0, 256, kTicksPerSecond, ""},
          Refused{RefusalCode::kFull, "the server is full"},
          Refused{RefusalCode::kOther, ""},
          Refused{RefusalCode::kOther, "the server is about to stop", "[2001:db8::1]:7777"},
          LevelChunk{5, 3, 0, {1, 2, 3}},
          LevelChunk{5, kMaxLevelBytes, kMaxLevelBytes - kChunkBytes, std::vector<std::uint8_t>(kChunkBytes, 9)},
          StateChunk{1, 2, 1, 4, 3, {7}},
          StateChunk{UINT32_MAX, UINT32_MAX, 255, kMaxStateBytes, 0, std::vector<std::uint8_t>(kChunkBytes, 8)},
          Roster{{{0, "Ann"}}},
          Roster{{{255, ""}, {7, "Łukasz Żółć 世界 32 bytes"}}},
          Roster{std::vector<RosterEntry>(kMaxRosterEntries, {3, std::string(kMaxNameBytes, 'x')})},
          Roster{},
          RoundStart{2, 17},
          RoundEnd{2, 3600, 18},
          RoundEnd{2, 3600, 18, "First steps", 300, LevelBest{1, "", false}},
          RoundEnd{UINT32_MAX, UINT32_MAX, UINT64_MAX, std::string(kMaxTitleBytes, 'x'), kMaxPauseTicks,
                   LevelBest{kMaxBestTicks, std::string(kMaxNameBytes, 'x'), true}},
          VoteCount{2, 3, 5},
          VoteCount{UINT32_MAX, kMaxPlayers, kMaxPlayers},
          VoteCount{},
          PlayerChat{0, {"Łukasz: 世界", 0}},
          PlayerChat{kMaxPlayers - 1, {std::string(kMaxChatBytes, 'x'), 0}},
          PlayerChat{7, {"", 1}},
          RoundTrips{},
          RoundTrips{{8, 0, 1, 255}},
          RoundTrips{std::vector<std::uint8_t>(kMaxPlayers, 13)},
          LocalSlots{{0}},
          LocalSlots{{255, {}, 0, {}}, "the server is full", 1},
          LocalSlots{{3, 4, 5, 6}, std::string(kMaxReasonBytes, 'x'), UINT32_MAX},
          Bye{ByeCode::kServerStops, "the server stops"},
          Bye{ByeCode::kServerStops, std::string(kMaxReasonBytes, 'x'), std::string(kMaxNextServerBytes, 'x')},
          Notice{"restart at noon"},
          Notice{std::string(kMaxReasonBytes, 'x')},
          Notice{},
          ConfirmedTicks{1, 0, 1, 5, std::nullopt, {}},
          ConfirmedTicks{1,
                         100,
                         120,
                         0x01020304,
                         LinkReport{200, 7, SlackReport{104, 3}},
                         {{100, 0, pressing(2)},
                          {103, 255, Input{}},
                          {219, 1, pressing(Input::kRight | Input::kCreep | Input::kDown | Input::kRestart)}}},
          ConfirmedTicks{2,
                         5,
                         3,
                         6,
                         LinkReport{0, 0, SlackReport{1, -4}},
                         {{5, 0, pressing(1)}, {5, 1, pressing(0)}, {7, 0, pressing(0)}},
                         255},
          ConfirmedTicks{2, 5, 3, 6, LinkReport{9, 100, std::nullopt}, {}},
          manyChanges()};
}

}  // namespace platon
