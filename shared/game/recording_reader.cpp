#include "platon/game/recording_reader.h"

#include <algorithm>

#include "platon/game/recording_format.h"
#include "platon/game/state_bytes.h"
#include "shared/exact/hash.h"

namespace platon {
namespace {

constexpr std::size_t kHashBytes = sizeof(std::uint64_t);

std::uint64_t readHash(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = 0;
  StateReader(bytes).read(hash);
  return hash;
}

// What bytes are that do not begin as recordings of this format do.
std::string otherFormat(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kName = kRecordingMagic.substr(0, kRecordingMagic.size() - 1);
  const bool isNamed = bytes.size() > kName.size() && std::equal(kName.begin(), kName.end(), bytes.begin());
  const std::uint8_t format = isNamed ? bytes[kName.size()] : 0;
  if (format < '0' || format > '9') return "not a recording, or an unsupported version";
  return "a recording of format " + std::to_string(format - '0') + ", but this program reads format " +
         std::to_string(kRecordingMagic.back() - '0');
}

// Reads the runs of one slot. False when they are not as long as the block, or one has an invalid input.
bool readRuns(StateReader& reader, std::uint32_t slot, RecordedBlock& block) {
  for (std::uint32_t tick = 0; tick < block.ticks();) {
    std::uint16_t length = 0;
    Input input;
    reader.read(length);
    reader.read(input.buttons);
    if (length == 0 || length > block.ticks() - tick || !isInput(input)) return false;
    for (const std::uint32_t end = tick + length; tick < end; ++tick) block.inputs[tick * block.slots + slot] = input;
  }
  return true;
}

}  // namespace

RecordingReader::RecordingReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) { readHead(); }

void RecordingReader::readHead() {
  constexpr std::size_t kFixed = kRecordingMagic.size() + 3 * sizeof(std::uint32_t);
  const std::size_t shared = std::min(bytes_.size(), kRecordingMagic.size());
  if (!std::equal(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(shared), kRecordingMagic.begin())) {
    return setDamaged(0, otherFormat(bytes_));
  }
  if (!hasBytes(kFixed)) return;
  StateReader reader(bytes_.subspan(kRecordingMagic.size()));
  std::uint32_t textBytes = 0;
  std::uint32_t complement = 0;
  std::uint32_t rules = 0;
  reader.read(rules);
  reader.read(textBytes);
  reader.read(complement);
  if (textBytes != ~complement) return setDamaged(0, "the length of the level text is wrong");
  if (textBytes > kMaxLevelBytes) {
    return setDamaged(0, "the level text is longer than " + std::to_string(kMaxLevelBytes) + " bytes");
  }
  if (!hasBytes(kFixed + textBytes + kHashBytes)) return;
  const auto head = bytes_.first(kFixed + textBytes);
  if (readHash(bytes_.subspan(head.size())) != hashOf(head)) {
    return setDamaged(0, "the checksum of the header is wrong");
  }
  rules_ = rules;
  levelText_ = head.subspan(kFixed);
  if (rules != kRulesVersion) {
    return setDamaged(kRecordingMagic.size(), "recorded with version " + std::to_string(rules) +
                                                  " of the rules, but this program has version " +
                                                  std::to_string(kRulesVersion));
  }
  LevelResult result = loadLevel(std::string(levelText_.begin(), levelText_.end()));
  if (!result.level) return setDamaged(kFixed, "the level is invalid: " + format("level", result.diagnostics.front()));
  level_ = std::move(result.level);
  offset_ = head.size() + kHashBytes;
}

std::optional<RecordedBlock> RecordingReader::next() {
  constexpr std::size_t kLengths = 2 * sizeof(std::uint32_t);
  if (state_ != State::kReading || !hasBytes(kLengths)) return std::nullopt;
  StateReader reader(bytes_.subspan(offset_));
  std::uint32_t length = 0;
  std::uint32_t complement = 0;
  reader.read(length);
  reader.read(complement);
  if (length != ~complement) return setDamaged(offset_, "the length of the block is wrong"), std::nullopt;
  if (!hasBytes(std::uint64_t{length} + kLengths + kHashBytes)) return std::nullopt;
  const auto body = reader.take(length);
  std::uint64_t hash = 0;
  reader.read(hash);
  if (hash != hashOf(body)) return setDamaged(offset_, "the checksum of the block is wrong"), std::nullopt;
  auto block = readBody(body, offset_);
  if (!block) return std::nullopt;
  offset_ += reader.next();
  if (block->ticks() != 0) return block;
  state_ = State::kComplete;
  if (offset_ != bytes_.size()) setDamaged(offset_, "unexpected bytes after the end of the recording");
  return block;
}

std::optional<RecordedBlock> RecordingReader::readBody(std::span<const std::uint8_t> bytes, std::size_t offset) {
  StateReader reader(bytes);
  RecordedBlock block;
  std::uint16_t ticks = 0;
  std::uint16_t slots = 0;
  std::uint32_t stateBytes = 0;
  block.offset = offset;
  reader.read(block.firstTick);
  reader.read(ticks);
  reader.read(slots);
  reader.read(stateBytes);
  const auto refuse = [&](std::string_view what) { return setDamaged(offset, what), std::nullopt; };
  if (ticks > kMaxCheckpointTicks || slots > kMaxPlayers) return refuse("the block has too many ticks or slots");
  // So that no sum of ticks wraps.
  if (block.firstTick > UINT32_MAX - ticks) return refuse("the block goes on beyond tick 4294967295");
  if (expectedTick_ && block.firstTick != *expectedTick_) {
    return refuse("the block begins at tick " + std::to_string(block.firstTick) + " instead of tick " +
                  std::to_string(*expectedTick_));
  }
  expectedTick_ = block.firstTick + ticks;
  const auto state = reader.take(stateBytes);
  block.state.assign(state.begin(), state.end());
  block.slots = slots;
  block.hashes.resize(ticks);
  block.inputs.resize(std::size_t{ticks} * slots);
  for (std::uint32_t slot = 0; slot < slots; ++slot) {
    if (!readRuns(reader, slot, block)) return refuse("the block has invalid inputs");
  }
  for (std::uint64_t& hash : block.hashes) reader.read(hash);
  if (!reader.finished()) return refuse("the length of the block does not match its content");
  return block;
}

// True when `count` bytes follow; otherwise the recording is truncated.
bool RecordingReader::hasBytes(std::uint64_t count) {
  if (bytes_.size() - offset_ >= count) return true;
  state_ = State::kTruncated;
  fault_ = "byte " + std::to_string(bytes_.size()) + ": the recording is truncated ";
  if (!level_) {
    fault_ += "within the header";
  } else if (offset_ == bytes_.size()) {
    fault_ += "before the block that marks its end";
  } else {
    fault_ += "within the block at byte " + std::to_string(offset_);
  }
  return false;
}

void RecordingReader::setDamaged(std::size_t offset, std::string_view what) {
  state_ = State::kDamaged;
  fault_ = "byte " + std::to_string(offset) + ": " + std::string(what);
}

}  // namespace platon
