#include "protocol/to_server.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "protocol/bytes.h"
#include "protocol/envelope.h"
#include "protocol/input_code.h"
#include "protocol/label.h"
#include "to_server_generated.h"

namespace platon {
namespace {

// The inputs of a companion follow a byte of kAbsentCode, which no run has, with the local number above it.
static_assert(kMaxLocalPlayers - 1 <= UINT8_MAX >> kInputCodeBits);

// A run of equal inputs is one byte: the code of the input in the low bits, the length above them. A length of 0 means
// that a varint follows: the length minus kLongRun.
constexpr std::uint32_t kLongRun = 1 << (8 - kInputCodeBits);

void writeRuns(ByteWriter& out, const std::vector<Input>& inputs) {
  for (auto run = inputs.begin(); run != inputs.end();) {
    const auto end = std::find_if(run, inputs.end(), [run](Input input) { return input != *run; });
    const auto length = static_cast<std::uint32_t>(end - run);
    const std::uint32_t count = length < kLongRun ? length : 0;
    out.byte(static_cast<std::uint8_t>(codeOf(*run) | count << kInputCodeBits));
    if (count == 0) out.varint(length - kLongRun);
    run = end;
  }
}

bool readRun(ByteReader& in, std::uint8_t head, Input input, std::vector<Input>& inputs) {
  std::uint32_t count = head >> kInputCodeBits;
  if (count == 0) count = std::min(in.varint(), kMaxInputsPerMessage) + kLongRun;
  if (count > kMaxInputsPerMessage - inputs.size()) return false;
  inputs.insert(inputs.end(), count, input);
  return true;
}

// Begins the inputs of a companion; `first`: of the message.
bool readCompanion(ByteReader& in, std::uint32_t local, std::uint32_t first, std::vector<CompanionInputs>& companions) {
  const std::uint32_t after = companions.empty() ? 0 : companions.back().local;
  const std::uint32_t later = in.varint();
  if (local <= after || later > UINT32_MAX - first) return false;
  companions.push_back({local, first + later, {}});
  return true;
}

// All inputs of a message, of which the rest has been read.
bool readInputs(ByteReader& in, PlayerInputs& message) {
  std::vector<Input>* inputs = &message.inputs;
  while (in.ok() && !in.atEnd()) {
    const std::uint8_t head = in.byte();
    const auto input = inputOf(head & kInputCodeMask);
    if (!input) return false;
    if (input->has(Input::kPresent)) {
      if (!readRun(in, head, *input, *inputs)) return false;
    } else {
      if (!readCompanion(in, head >> kInputCodeBits, message.first, message.companions)) return false;
      inputs = &message.companions.back().inputs;
    }
  }
  return in.ok();
}

bool endsInTime(std::uint32_t first, const std::vector<Input>& inputs) {
  return std::uint64_t{first} + inputs.size() <= UINT32_MAX;
}

bool isValid(const PlayerInputs& message) {
  return endsInTime(message.first, message.inputs) &&
         std::all_of(message.companions.begin(), message.companions.end(), [](const CompanionInputs& each) {
           return !each.inputs.empty() && endsInTime(each.first, each.inputs);
         });
}

std::vector<std::uint8_t> packInputs(const PlayerInputs& message) {
  ByteWriter out;
  out.byte(kTickMessage);
  out.varint(message.round);
  out.byte(message.sequence);
  out.byte(message.sync);
  out.varint(message.confirmed);
  out.fixed32(message.hash);
  out.varint(message.first - message.confirmed);
  writeRuns(out, message.inputs);
  for (const CompanionInputs& companion : message.companions) {
    out.byte(static_cast<std::uint8_t>(kAbsentCode | companion.local << kInputCodeBits));
    out.varint(companion.first - message.first);
    writeRuns(out, companion.inputs);
  }
  return out.take();
}

std::optional<PlayerInputs> unpackInputs(std::span<const std::uint8_t> bytes) {
  ByteReader in(bytes);
  PlayerInputs message;
  message.round = in.varint();
  message.sequence = in.byte();
  message.sync = in.byte();
  message.confirmed = in.varint();
  message.hash = in.fixed32();
  const std::uint32_t ahead = in.varint();
  if (!in.ok() || ahead > UINT32_MAX - message.confirmed) return std::nullopt;
  message.first = message.confirmed + ahead;
  if (!readInputs(in, message) || !isValid(message)) return std::nullopt;
  return message;
}

// Copies the numbers, since the verifier does not guarantee that they are aligned.
std::vector<std::uint64_t> levelsOf(const flatbuffers::Vector<std::uint64_t>& vector) {
  std::vector<std::uint64_t> levels(vector.size());
  if (!levels.empty()) std::memcpy(levels.data(), vector.Data(), levels.size() * sizeof(std::uint64_t));
  for (std::uint64_t& level : levels) level = flatbuffers::EndianScalar(level);
  return levels;
}

bool readSession(const wire::Hello& table, Hello& hello) {
  if (table.token()) {
    hello.token = tokenOf(spanOf(table.token()));
    if (!hello.token) return false;
  }
  if (table.levels()) hello.levels = levelsOf(*table.levels());
  return hello.levels.size() <= kMaxLevelsKnown;
}

std::optional<ToServer> readHello(const wire::Hello& table) {
  Hello hello;
  hello.rulesVersion = table.rules_version();
  hello.name = textOf(table.name());
  if (!isLabel(hello.name, kMaxNameBytes) || !readSession(table, hello)) return std::nullopt;
  return hello;
}

std::optional<ToServer> readChat(const wire::LocalChat& table) {
  LocalChat message{table.local(), {textOf(table.text()), table.emote()}};
  if (message.local >= kMaxLocalPlayers || !isChat(message.chat)) return std::nullopt;
  return message;
}

std::optional<ToServer> readCompanion(const wire::Companion& table) {
  Companion companion{table.local(), table.joins(), textOf(table.name())};
  const bool isNamed = isLabel(companion.name, kMaxNameBytes) && (companion.joins || companion.name.empty());
  if (companion.local == 0 || !isNamed) return std::nullopt;
  return companion;
}

std::optional<ToServer> readBody(const wire::ToServer& root) {
  switch (root.body_type()) {
    case wire::ToServerBody::Hello:
      return readHello(*root.body_as_Hello());
    case wire::ToServerBody::LevelRequest:
      return LevelRequest{root.body_as_LevelRequest()->hash()};
    case wire::ToServerBody::Leave:
      return Leave{};
    case wire::ToServerBody::Vote:
      return Vote{root.body_as_Vote()->round(), root.body_as_Vote()->next()};
    case wire::ToServerBody::LocalChat:
      return readChat(*root.body_as_LocalChat());
    case wire::ToServerBody::Companion:
      return readCompanion(*root.body_as_Companion());
    default:
      return std::nullopt;
  }
}

template <class Body>
std::vector<std::uint8_t> finish(flatbuffers::FlatBufferBuilder& builder, wire::ToServerBody type,
                                 flatbuffers::Offset<Body> body) {
  builder.Finish(wire::CreateToServer(builder, type, body.Union()));
  return bytesOf(builder);
}

}  // namespace

std::optional<ToServer> decodeToServer(std::span<const std::uint8_t> bytes) {
  if (isTickMessage(bytes)) return unpackInputs(bytes.subspan(1));
  const Envelope<wire::ToServer> envelope(bytes);
  const wire::ToServer* root = envelope.root();
  return root && root->body() ? readBody(*root) : std::nullopt;
}

std::vector<std::uint8_t> encode(const Hello& message) {
  assert(message.levels.size() <= kMaxLevelsKnown);
  flatbuffers::FlatBufferBuilder builder;
  const auto name = builder.CreateString(message.name);
  const auto levels = message.levels.empty() ? 0 : builder.CreateVector(message.levels);
  const auto token = message.token ? builder.CreateVector(message.token->data(), message.token->size()) : 0;
  return finish(builder, wire::ToServerBody::Hello,
                wire::CreateHello(builder, message.rulesVersion, name, token, levels));
}

std::vector<std::uint8_t> encode(const LevelRequest& message) {
  flatbuffers::FlatBufferBuilder builder;
  return finish(builder, wire::ToServerBody::LevelRequest, wire::CreateLevelRequest(builder, message.hash));
}

std::vector<std::uint8_t> encode(const Leave&) {
  flatbuffers::FlatBufferBuilder builder;
  return finish(builder, wire::ToServerBody::Leave, wire::CreateLeave(builder));
}

std::vector<std::uint8_t> encode(const Vote& message) {
  flatbuffers::FlatBufferBuilder builder;
  return finish(builder, wire::ToServerBody::Vote, wire::CreateVote(builder, message.round, message.next));
}

std::vector<std::uint8_t> encode(const LocalChat& message) {
  assert(isChat(message.chat) && message.local < kMaxLocalPlayers);
  flatbuffers::FlatBufferBuilder builder;
  const auto text = message.chat.text.empty() ? 0 : builder.CreateString(message.chat.text);
  return finish(builder, wire::ToServerBody::LocalChat,
                wire::CreateLocalChat(builder, text, message.chat.emote, message.local));
}

std::vector<std::uint8_t> encode(const Companion& message) {
  assert(message.local > 0 && (message.joins || message.name.empty()));
  flatbuffers::FlatBufferBuilder builder;
  const auto name = message.name.empty() ? 0 : builder.CreateString(message.name);
  return finish(builder, wire::ToServerBody::Companion,
                wire::CreateCompanion(builder, message.local, message.joins, name));
}

std::vector<std::uint8_t> encode(const PlayerInputs& message) {
  assert(message.first >= message.confirmed && message.inputs.size() <= kMaxInputsPerMessage);
  return packInputs(message);
}

}  // namespace platon
