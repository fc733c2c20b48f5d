#include "client/replay/replay.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "protocol/files/text_file.h"

namespace platon {

std::optional<RecordingHead> readRecordingHead(std::span<const std::uint8_t> bytes) {
  const RecordingReader recording(bytes);
  if (recording.level()) return RecordingHead{kRulesVersion, recording.level()};
  if (!recording.rules() || *recording.rules() == kRulesVersion) return std::nullopt;
  const std::span<const std::uint8_t> text = recording.levelText();
  return RecordingHead{*recording.rules(), loadLevel(std::string(text.begin(), text.end())).level};
}

std::string otherRulesText(std::uint32_t rules) {
  return "was recorded with version " + std::to_string(rules) + " of the rules; this program has version " +
         std::to_string(kRulesVersion) + " and cannot play it";
}

std::string damagedText(const std::string& fault) { return "is a damaged recording: " + fault; }

std::string recordingFault(const RecordingReader& reader, std::span<const std::uint8_t> recording) {
  if (reader.state() == RecordingReader::State::kComplete) return {};
  const std::optional<RecordingHead> head = readRecordingHead(recording);
  if (head && head->rules != kRulesVersion) return otherRulesText(head->rules);
  if (reader.state() == RecordingReader::State::kTruncated) return "is a recording that is cut off: " + reader.fault();
  return head ? damagedText(reader.fault()) : "cannot be played: " + reader.fault();
}

namespace {

// So that no tick is above 2^32.
constexpr std::uint32_t kMaxFirstTick = UINT32_MAX - PlayCost::kMax / PlayCost::kBase;

// What a round of 256 players costs, as PlayCost::add counts it.
constexpr std::uint64_t costOfFullRound(std::uint64_t segments) {
  return std::uint64_t{kRoundTicks} * (kMaxPlayers + 1) * (PlayCost::kBase + segments);
}

static_assert(costOfFullRound(31) <= PlayCost::kMax && costOfFullRound(32) > PlayCost::kMax, "mend the text of kMax");

}  // namespace

std::optional<Game> gameBefore(const RecordedBlock& first, const std::shared_ptr<const Level>& level) {
  Game game(level);
  const bool valid = game.restore(first.state) && game.tick() == first.firstTick && game.tick() <= kMaxFirstTick;
  return valid ? std::optional(std::move(game)) : std::nullopt;
}

bool PlayCost::add(std::uint32_t ticks, std::uint32_t slots) {
  slots_ = std::max(slots_, slots);
  sum_ += ticks * (std::uint64_t{slots_} + 1) * ofPlayer_;
  return sum_ <= kMax;
}

std::variant<std::shared_ptr<const Replay>, std::string> Replay::read(std::span<const std::uint8_t> recording,
                                                                      const std::stop_token& stop,
                                                                      ReplayProgress* progress) {
  RecordingReader reader(recording);
  std::optional<RecordedBlock> first = reader.next();
  if (!first) return recordingFault(reader, recording);
  std::optional<Game> start = gameBefore(*first, reader.level());
  if (!start) return kNoStart;
  const std::shared_ptr<Replay> replay(new Replay(std::move(*start)));
  std::string fault = replay->readBlocks(reader, std::move(*first), stop);
  if (fault.empty()) fault = recordingFault(reader, recording);
  if (fault.empty()) fault = replay->play(stop, progress);
  if (!fault.empty()) return fault;
  return replay;
}

std::string Replay::readBlocks(RecordingReader& reader, RecordedBlock first, const std::stop_token& stop) {
  std::string fault = add(std::move(first));
  while (fault.empty()) {
    if (stop.stop_requested()) return kStopped;
    std::optional<RecordedBlock> block = reader.next();
    if (!block) break;
    fault = add(std::move(*block));
  }
  return fault;
}

std::string Replay::add(RecordedBlock block) {
  ticks_ += block.ticks();
  const bool affordable = cost_.add(block.ticks(), block.slots);
  blocks_.push_back(std::move(block));
  return affordable ? "" : kTooLong;
}

// Plays it once. The recorded states and hashes must be those of this program.
std::string Replay::play(const std::stop_token& stop, ReplayProgress* progress) {
  interval_ = std::max(kMinInterval, ticks_ / (kMaxStates - 1) + 1);
  Game game = start_;
  Game before = start_;  // the last tick
  RecordedRun run(start_);
  std::uint32_t tick = 0;
  const auto differs = [&] {
    return damagedText("playing it does not lead to the recorded state at tick " + std::to_string(game.tick()));
  };
  for (RecordedBlock& block : blocks_) {
    if (game.save() != block.state) return differs();
    for (std::uint32_t i = 0; i < block.ticks(); ++i, ++tick) {
      if (stop.stop_requested()) return kStopped;
      if (progress != nullptr) *progress = static_cast<std::uint32_t>(std::uint64_t{tick} * 100 / ticks_);
      if (tick % interval_ == 0) states_.push_back(game.save());
      if (tick + 1 == ticks_) before = game;
      run.add(block.inputsOf(i));
      game.advance(block.inputsOf(i));
      if (game.hash() != block.hashes[i]) return differs();
    }
    block.hashes = {};
    block.state = {};
  }
  if (tick % interval_ == 0) states_.push_back(game.save());
  run_ = run.finish(before, game);
  return {};
}

std::span<const Input> Replay::inputsOf(std::uint32_t tick) const {
  const std::uint32_t recorded = start_.tick() + tick;
  const auto next = std::upper_bound(blocks_.begin(), blocks_.end(), recorded,
                                     [](std::uint32_t at, const RecordedBlock& block) { return at < block.firstTick; });
  const RecordedBlock& block = *std::prev(next);
  return block.inputsOf(recorded - block.firstTick);
}

Game Replay::gameAfter(std::uint32_t tick) const {
  Game game(level());
  std::uint32_t reached = tick / interval_ * interval_;
  game.restore(states_[reached / interval_]);
  for (; reached < tick; ++reached) game.advance(inputsOf(reached));
  return game;
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxHeadBytes = kMaxLevelBytes + 64;
constexpr std::size_t kPartBytes = std::size_t{1} << 20;  // that are read at a time

std::span<const std::uint8_t> bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

std::string unreadable(const std::string& reason) { return "cannot be read: " + reason; }

// At most one byte more than `maxBytes`. Returns why it failed, or an empty text.
std::string readParts(const Descriptor& file, std::size_t maxBytes, std::string& content, const std::stop_token& stop) {
  while (content.size() <= maxBytes) {
    if (stop.stop_requested()) return Replay::kStopped;
    const std::size_t before = content.size();
    const std::size_t part = std::min(kPartBytes, maxBytes + 1 - before);
    content.resize(before + part);
    const std::optional<std::size_t> read = readNext(file, content.data() + before, part);
    content.resize(before + read.value_or(0));
    if (!read) return unreadable(std::strerror(errno));
    if (*read < part) break;
  }
  return {};
}

// At most one byte more than `maxBytes`, and room for as many as the file has: it may be small.
RecordingBytes readFile(const fs::path& file, std::size_t maxBytes, const std::stop_token& stop) {
  const OpenedFile opened = openToRead(file.string());
  if (!opened.file) return {{}, unreadable(opened.fault)};
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(file, fault);
  const auto limit = fault ? maxBytes : static_cast<std::size_t>(std::min<std::uintmax_t>(size, maxBytes));
  RecordingBytes bytes;
  bytes.fault = readParts(opened.file, limit, bytes.content, stop);
  return bytes;
}

}  // namespace

std::span<const std::uint8_t> RecordingBytes::bytes() const { return bytesOf(content); }

RecordingBytes readRecordingBytes(const fs::path& file, const std::stop_token& stop) {
  RecordingBytes read = readFile(file, Replay::kMaxBytes, stop);
  if (read.content.size() > Replay::kMaxBytes) return {{}, "is larger than any recording that can be played"};
  return read;
}

std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const fs::path& file, const std::stop_token& stop,
                                                                    ReplayProgress* progress) {
  const RecordingBytes read = readRecordingBytes(file, stop);
  if (!read.fault.empty()) return file.string() + ": " + read.fault;
  auto replay = Replay::read(read.bytes(), stop, progress);
  if (const auto* fault = std::get_if<std::string>(&replay)) return file.string() + ": " + *fault;
  return replay;
}

std::optional<RecordingHead> readRecordingHeadOf(const fs::path& file, const std::stop_token& stop) {
  const RecordingBytes read = readFile(file, kMaxHeadBytes, stop);
  return read.fault.empty() ? readRecordingHead(read.bytes()) : std::nullopt;
}

}  // namespace platon
