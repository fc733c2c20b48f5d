#include "protocol/to_client.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

#include "protocol/bytes.h"
#include "protocol/envelope.h"
#include "protocol/input_code.h"
#include "protocol/label.h"
#include "to_client_generated.h"

namespace platon {
namespace {

using Builder = flatbuffers::FlatBufferBuilder;
using Bytes = std::vector<std::uint8_t>;
using Body = wire::ToClientBody;

// An input change is two bytes: the code of the input, with the ticks since the last change in the high bits, then the
// slot. kLongGap in the high bits means that a varint follows the first byte: the ticks minus kLongGap.
constexpr std::uint32_t kLongGap = 3;

void writeChange(ByteWriter& out, const InputChange& change, std::uint32_t gap) {
  out.byte(static_cast<std::uint8_t>(codeOf(change.input) | std::min(gap, kLongGap) << kInputCodeBits));
  if (gap >= kLongGap) out.varint(gap - kLongGap);
  out.byte(static_cast<std::uint8_t>(change.slot));
}

std::optional<InputChange> readChange(ByteReader& in, std::uint32_t lastTick) {
  const std::uint8_t head = in.byte();
  std::uint32_t gap = head >> kInputCodeBits;
  if (gap == kLongGap) gap += std::min(in.varint(), kMaxTicksPerMessage);
  const auto input = inputOf(head & kInputCodeMask);
  const std::uint8_t slot = in.byte();
  if (!in.ok() || !input) return std::nullopt;
  return InputChange{lastTick + gap, slot, *input};
}

bool isAfter(const InputChange& change, const InputChange& last) {
  return change.tick > last.tick || (change.tick == last.tick && change.slot > last.slot);
}

bool readChanges(ByteReader& in, ConfirmedTicks& message) {
  std::uint32_t lastTick = message.from;
  while (!in.atEnd()) {
    const auto change = readChange(in, lastTick);
    if (!change || change->tick - message.from >= message.count) return false;
    if (!message.changes.empty() && !isAfter(*change, message.changes.back())) return false;
    if (message.changes.size() == kMaxChangesPerMessage) return false;
    message.changes.push_back(*change);
    lastTick = change->tick;
  }
  return true;
}

// Zigzag encoding: the sign in the lowest bit, so that small numbers stay short.
std::uint32_t packSigned(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? ~(bits << 1) : bits << 1;
}

std::int32_t unpackSigned(std::uint32_t packed) {
  return static_cast<std::int32_t>(packed & 1 ? ~(packed >> 1) : packed >> 1);
}

// First number of a link report. Larger values encode the slack; the tick of the slack follows, relative to `from`.
constexpr std::uint32_t kNoReport = 0;
constexpr std::uint32_t kReportWithoutSlack = 1;

void writeLinkReport(ByteWriter& out, const ConfirmedTicks& message) {
  if (!message.link) return out.varint(kNoReport);
  const std::optional<SlackReport>& slack = message.link->slack;
  out.varint(slack ? kReportWithoutSlack + 1 + packSigned(slack->slack) : kReportWithoutSlack);
  out.byte(message.link->sequence);
  out.byte(message.link->lostPercent);
  if (slack) out.varint(packSigned(static_cast<std::int32_t>(slack->tick - message.from)));
}

bool readLinkReport(ByteReader& in, ConfirmedTicks& message) {
  const std::uint32_t head = in.varint();
  if (head == kNoReport) return in.ok();
  LinkReport report;
  report.sequence = in.byte();
  report.lostPercent = in.byte();
  if (head > kReportWithoutSlack) {
    const auto tick = message.from + static_cast<std::uint32_t>(unpackSigned(in.varint()));
    report.slack = SlackReport{tick, unpackSigned(head - kReportWithoutSlack - 1)};
    if (report.slack->slack < -kMaxSlack || report.slack->slack > kMaxSlack) return false;
  }
  message.link = report;
  return in.ok() && report.lostPercent <= 100;
}

Bytes pack(const ConfirmedTicks& message) {
  ByteWriter out;
  out.byte(kTickMessage);
  out.varint(message.round);
  out.varint(message.from);
  out.varint(message.count);
  out.fixed32(message.hash);
  out.byte(message.sequence);
  writeLinkReport(out, message);
  std::uint32_t lastTick = message.from;
  for (const InputChange& change : message.changes) {
    writeChange(out, change, change.tick - lastTick);
    lastTick = change.tick;
  }
  return out.take();
}

std::optional<ToClient> unpack(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  ConfirmedTicks message;
  message.round = in.varint();
  message.from = in.varint();
  message.count = in.varint();
  message.hash = in.fixed32();
  message.sequence = in.byte();
  const bool counts =
      message.count >= 1 && message.count <= kMaxTicksPerMessage && message.from <= UINT32_MAX - message.count;
  if (!in.ok() || !counts || !readLinkReport(in, message) || !readChanges(in, message)) return std::nullopt;
  return message;
}

bool isChunk(std::uint32_t total, std::size_t maxTotal, std::uint32_t offset, std::size_t size) {
  return total <= maxTotal && size >= 1 && size <= kChunkBytes && offset <= total && size <= total - offset;
}

std::optional<ToClient> read(const wire::Welcome& table) {
  Welcome message{table.slot(),
                  table.round(),
                  table.level_hash(),
                  table.max_players(),
                  table.ticks_per_second(),
                  textOf(table.server_name())};
  const bool valid = message.maxPlayers <= kMaxPlayers && message.slot < message.maxPlayers &&
                     message.ticksPerSecond == kTicksPerSecond && isLabel(message.serverName, kMaxNameBytes);
  return valid ? std::optional<ToClient>(std::move(message)) : std::nullopt;
}

RefusalCode refusalCode(std::uint32_t code) {
  const bool known = code == static_cast<std::uint32_t>(RefusalCode::kWrongRules) ||
                     code == static_cast<std::uint32_t>(RefusalCode::kFull);
  return known ? static_cast<RefusalCode>(code) : RefusalCode::kOther;
}

std::optional<ToClient> read(const wire::Refused& table) {
  Refused message{refusalCode(table.code()), textOf(table.reason()), textOf(table.next())};
  if (!isLabel(message.reason, kMaxReasonBytes) || !isLabel(message.next, kMaxNextServerBytes)) return std::nullopt;
  return message;
}

std::optional<ToClient> read(const wire::LevelChunk& table) {
  const auto bytes = spanOf(table.bytes());
  if (!isChunk(table.total(), kMaxLevelBytes, table.offset(), bytes.size())) return std::nullopt;
  return LevelChunk{table.hash(), table.total(), table.offset(), {bytes.begin(), bytes.end()}};
}

std::optional<ToClient> read(const wire::StateChunk& table) {
  const auto bytes = spanOf(table.bytes());
  if (!isChunk(table.total(), kMaxStateBytes, table.offset(), bytes.size()) || table.sync() == 0) return std::nullopt;
  return StateChunk{table.round(), table.tick(),   table.sync(),
                    table.total(), table.offset(), {bytes.begin(), bytes.end()}};
}

std::optional<ToClient> read(const wire::Roster& table) {
  if (!table.entries() || table.entries()->size() > kMaxRosterEntries) return std::nullopt;
  Roster message;
  for (const wire::RosterEntry* entry : *table.entries()) {
    message.entries.push_back({entry->slot(), textOf(entry->name())});
    const RosterEntry& last = message.entries.back();
    if (last.slot >= kMaxPlayers || !isLabel(last.name, kMaxNameBytes)) return std::nullopt;
  }
  return message;
}

std::optional<ToClient> read(const wire::RoundStart& table) { return RoundStart{table.round(), table.level_hash()}; }

std::optional<ToClient> read(const wire::RoundEnd& table) {
  RoundEnd message{
      table.round(), table.tick(), table.next_level_hash(), textOf(table.next_title()), table.pause_ticks(), {}};
  if (!isLabel(message.nextTitle, kMaxTitleBytes) || message.pauseTicks > kMaxPauseTicks) return std::nullopt;
  if (table.best_ticks() == 0) return message;
  message.best = LevelBest{table.best_ticks(), textOf(table.best_name()), table.best_is_new()};
  if (message.best->ticks > kMaxBestTicks || !isLabel(message.best->name, kMaxNameBytes)) return std::nullopt;
  return message;
}

ByeCode byeCode(std::uint32_t code) {
  const bool known = code >= 1 && code <= static_cast<std::uint32_t>(ByeCode::kRemoved);
  return known ? static_cast<ByeCode>(code) : ByeCode::kOther;
}

std::optional<ToClient> read(const wire::Bye& table) {
  Bye message{byeCode(table.code()), textOf(table.reason()), textOf(table.next())};
  if (!isLabel(message.reason, kMaxReasonBytes) || !isLabel(message.next, kMaxNextServerBytes)) return std::nullopt;
  return message;
}

std::optional<ToClient> read(const wire::Notice& table) {
  Notice message{textOf(table.text())};
  if (!isLabel(message.text, kMaxReasonBytes)) return std::nullopt;
  return message;
}

std::optional<ToClient> read(const wire::VoteCount& table) {
  const VoteCount message{table.round(), table.votes(), table.voters()};
  if (message.voters > kMaxPlayers || message.votes > message.voters) return std::nullopt;
  return message;
}

std::optional<ToClient> read(const wire::PlayerChat& table) {
  PlayerChat message{table.slot(), {textOf(table.text()), table.emote()}};
  if (message.slot >= kMaxPlayers || !isChat(message.chat)) return std::nullopt;
  return message;
}

std::optional<ToClient> read(const wire::RoundTrips& table) {
  const auto codes = spanOf(table.codes());
  if (codes.size() > kMaxPlayers) return std::nullopt;
  return RoundTrips{{codes.begin(), codes.end()}};
}

// The bits of `taken` say which local numbers have a slot; those of others mean nothing.
std::optional<ToClient> read(const wire::LocalSlots& table) {
  const auto slots = spanOf(table.slots());
  const bool isFirstIn = (table.taken() & 1) != 0;
  if (slots.size() != kMaxLocalPlayers || table.taken() >> kMaxLocalPlayers != 0 || !isFirstIn) return std::nullopt;
  LocalSlots message{{}, textOf(table.reason()), table.local()};
  if (!isLabel(message.reason, kMaxReasonBytes)) return std::nullopt;
  for (std::size_t local = 0; local < slots.size(); ++local) {
    if ((table.taken() >> local & 1) == 0) continue;
    const std::optional<std::uint32_t> slot = slots[local];
    if (std::find(message.slots.begin(), message.slots.end(), slot) != message.slots.end()) return std::nullopt;
    message.slots[local] = slot;
  }
  return message;
}

std::optional<ToClient> readBody(const wire::ToClient& root) {
  switch (root.body_type()) {
    case Body::Welcome:
      return read(*root.body_as_Welcome());
    case Body::Refused:
      return read(*root.body_as_Refused());
    case Body::LevelChunk:
      return read(*root.body_as_LevelChunk());
    case Body::StateChunk:
      return read(*root.body_as_StateChunk());
    case Body::Roster:
      return read(*root.body_as_Roster());
    case Body::RoundStart:
      return read(*root.body_as_RoundStart());
    case Body::RoundEnd:
      return read(*root.body_as_RoundEnd());
    case Body::Bye:
      return read(*root.body_as_Bye());
    case Body::Notice:
      return read(*root.body_as_Notice());
    case Body::VoteCount:
      return read(*root.body_as_VoteCount());
    case Body::PlayerChat:
      return read(*root.body_as_PlayerChat());
    case Body::RoundTrips:
      return read(*root.body_as_RoundTrips());
    case Body::LocalSlots:
      return read(*root.body_as_LocalSlots());
    default:
      return std::nullopt;
  }
}

template <class Table>
Bytes finish(Builder& builder, Body type, flatbuffers::Offset<Table> body) {
  builder.Finish(wire::CreateToClient(builder, type, body.Union()));
  return bytesOf(builder);
}

}  // namespace

std::optional<ToClient> decodeToClient(std::span<const std::uint8_t> bytes) {
  if (isTickMessage(bytes)) return unpack(bytes.subspan(1));
  const Envelope<wire::ToClient> envelope(bytes);
  const wire::ToClient* root = envelope.root();
  return root && root->body() ? readBody(*root) : std::nullopt;
}

Bytes encode(const Welcome& message) {
  Builder builder;
  const auto name = builder.CreateString(message.serverName);
  return finish(builder, Body::Welcome,
                wire::CreateWelcome(builder, message.slot, message.round, message.levelHash, message.maxPlayers,
                                    message.ticksPerSecond, name));
}

Bytes encode(const Refused& message) {
  Builder builder;
  const auto reason = builder.CreateString(message.reason);
  const auto next = message.next.empty() ? 0 : builder.CreateString(message.next);
  const auto code = static_cast<std::uint32_t>(message.code);
  return finish(builder, Body::Refused, wire::CreateRefused(builder, code, reason, next));
}

Bytes encode(const LevelChunk& message) {
  Builder builder;
  const auto bytes = builder.CreateVector(message.bytes);
  return finish(builder, Body::LevelChunk,
                wire::CreateLevelChunk(builder, message.hash, message.total, message.offset, bytes));
}

Bytes encode(const StateChunk& message) {
  Builder builder;
  const auto bytes = builder.CreateVector(message.bytes);
  return finish(
      builder, Body::StateChunk,
      wire::CreateStateChunk(builder, message.round, message.tick, message.sync, message.total, message.offset, bytes));
}

Bytes encode(const Roster& message) {
  assert(message.entries.size() <= kMaxRosterEntries);
  Builder builder;
  std::vector<flatbuffers::Offset<wire::RosterEntry>> entries;
  for (const RosterEntry& entry : message.entries) {
    const auto name = builder.CreateString(entry.name);
    entries.push_back(wire::CreateRosterEntry(builder, entry.slot, name));
  }
  return finish(builder, Body::Roster, wire::CreateRoster(builder, builder.CreateVector(entries)));
}

Bytes encode(const RoundStart& message) {
  Builder builder;
  return finish(builder, Body::RoundStart, wire::CreateRoundStart(builder, message.round, message.levelHash));
}

Bytes encode(const RoundEnd& message) {
  Builder builder;
  const LevelBest best = message.best.value_or(LevelBest());
  const auto title = message.nextTitle.empty() ? 0 : builder.CreateString(message.nextTitle);
  const auto name = best.name.empty() ? 0 : builder.CreateString(best.name);
  return finish(builder, Body::RoundEnd,
                wire::CreateRoundEnd(builder, message.round, message.tick, message.nextLevelHash, title,
                                     message.pauseTicks, best.ticks, name, best.isNew));
}

Bytes encode(const Bye& message) {
  Builder builder;
  const auto reason = builder.CreateString(message.reason);
  const auto next = message.next.empty() ? 0 : builder.CreateString(message.next);
  const auto code = static_cast<std::uint32_t>(message.code);
  return finish(builder, Body::Bye, wire::CreateBye(builder, code, reason, next));
}

Bytes encode(const Notice& message) {
  Builder builder;
  const auto text = builder.CreateString(message.text);
  return finish(builder, Body::Notice, wire::CreateNotice(builder, text));
}

Bytes encode(const VoteCount& message) {
  Builder builder;
  return finish(builder, Body::VoteCount, wire::CreateVoteCount(builder, message.round, message.votes, message.voters));
}

Bytes encode(const PlayerChat& message) {
  assert(isChat(message.chat));
  Builder builder;
  const auto text = message.chat.text.empty() ? 0 : builder.CreateString(message.chat.text);
  return finish(builder, Body::PlayerChat, wire::CreatePlayerChat(builder, message.slot, text, message.chat.emote));
}

Bytes encode(const RoundTrips& message) {
  assert(message.codes.size() <= kMaxPlayers);
  Builder builder;
  const auto codes = builder.CreateVector(message.codes);
  return finish(builder, Body::RoundTrips, wire::CreateRoundTrips(builder, codes));
}

Bytes encode(const LocalSlots& message) {
  assert(message.slots[0]);
  Builder builder;
  std::uint8_t taken = 0;
  std::array<std::uint8_t, kMaxLocalPlayers> slots{};
  for (std::size_t local = 0; local < slots.size(); ++local) {
    slots[local] = static_cast<std::uint8_t>(message.slots[local].value_or(0));
    if (message.slots[local]) taken |= static_cast<std::uint8_t>(1U << local);
  }
  const auto vector = builder.CreateVector(slots.data(), slots.size());
  const auto reason = message.reason.empty() ? 0 : builder.CreateString(message.reason);
  return finish(builder, Body::LocalSlots, wire::CreateLocalSlots(builder, taken, vector, reason, message.local));
}

Bytes encode(const ConfirmedTicks& message) {
  assert(message.count >= 1 && message.count <= kMaxTicksPerMessage);
  assert(message.changes.size() <= kMaxChangesPerMessage);
  assert(!message.link || message.link->lostPercent <= 100);
  assert(!message.link || !message.link->slack || std::abs(message.link->slack->slack) <= kMaxSlack);
  return pack(message);
}

}  // namespace platon
