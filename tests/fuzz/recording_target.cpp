#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

#include "client/replay/replay.h"
#include "client/replay/run_track.h"
#include "platon/game/game.h"
#include "platon/game/recorded_run.h"
#include "platon/game/recorder.h"
#include "platon/game/recording_reader.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/shared/game/forged_recording.h"

namespace platon::fuzz {
namespace {

constexpr std::uint32_t kMaxRecordedTicks = 64;

const std::shared_ptr<const Level>& tetrahedron() {
  static const std::shared_ptr<const Level> loaded =
      loadLevel("TETRAHEDRON\n0 0 -55 0\n2 0 0\n240\n%\n-60 -69.2 60 -69.2\n%\n%\n%\n").level;
  return loaded;
}

// A valid recording of a game with inputs from the bytes, in blocks of a few ticks.
std::vector<std::uint8_t> recorded(ByteSource& bytes) {
  Game game(tetrahedron());
  Recorder recorder(game, static_cast<std::uint32_t>(bytes.below(8)) + 1);
  for (std::size_t ticks = bytes.below(kMaxRecordedTicks); ticks > 0; --ticks) {
    std::vector<Input> inputs(bytes.below(4));
    for (Input& input : inputs) input = validInput(bytes.byte() | Input::kPresent);
    game.advance(inputs);
    recorder.record(inputs, game);
  }
  recorder.finish(game);
  return recorder.takeBytes();
}

// Random blocks with valid checksums.
std::vector<std::uint8_t> forged(ByteSource& bytes) {
  ForgedRecording recording{Game(tetrahedron())};
  for (std::size_t blocks = bytes.below(4); blocks > 0; --blocks) {
    std::vector<std::uint8_t> body(bytes.below(256));
    for (std::uint8_t& byte : body) byte = bytes.byte();
    recording.addBody(body);
  }
  return recording.bytes();
}

std::string play(const RecordedBlock& block) {
  if (block.inputs.size() != std::size_t{block.ticks()} * block.slots)
    return "a block does not have one input per slot and tick";
  if (!std::all_of(block.inputs.begin(), block.inputs.end(), isInput)) return "a block has an invalid input";
  Game game(tetrahedron());
  if (!game.restore(block.state)) return {};
  for (std::uint32_t tick = 0; tick < std::min(block.ticks(), kMaxRecordedTicks); ++tick)
    game.advance(block.inputsOf(tick));
  return {};
}

std::string readFault(Bytes recording, bool isValid) {
  RecordingReader reader(recording);
  while (const auto block = reader.next()) {
    if (std::string fault = play(*block); !fault.empty()) return fault;
  }
  if (reader.state() == RecordingReader::State::kReading) return "reading ends before the recording does";
  if ((reader.state() == RecordingReader::State::kComplete) != reader.fault().empty())
    return "fault message and reader state contradict each other";
  return isValid && reader.state() != RecordingReader::State::kComplete ? "a valid recording is refused"
                                                                        : std::string();
}

// As the client plays the file of a friend.
std::string replayFault(Bytes recording, bool isValid) {
  const std::optional<RecordingHead> head = readRecordingHead(recording);
  if (isValid && (!head || !head->level)) return "the head of a valid recording is refused";
  const auto read = Replay::read(recording);
  if (const auto* fault = std::get_if<std::string>(&read)) {
    if (isValid) return "a valid recording cannot be played: " + *fault;
    return fault->empty() ? "a recording is refused without a reason" : std::string();
  }
  if (!head) return "a recording without a head can be played";
  const Replay& replay = *std::get<std::shared_ptr<const Replay>>(read);
  const std::optional<RunTrack> track = trackOf(replay);
  if (track && (track->ticks > replay.ticks() || track->places.size() != track->ticks + std::size_t{1}))
    return "a run does not have one place per tick";
  if (!track || track->ticks != replay.ticks() || !track->places.front().present) return {};
  const std::uint32_t slot = std::get<RunFinish>(replay.run()).slot;
  const bool restarts = replay.inputsOf(0)[slot].has(Input::kRestart);
  return restarts || LevelRest(replay.level()).ticksTo(replay.gameAfter(0), slot)
             ? std::string()
             : "a run begins elsewhere than at the start of the level";
}

std::string faultOf(Bytes recording, bool isValid) {
  std::string fault = readFault(recording, isValid);
  return fault.empty() ? replayFault(recording, isValid) : fault;
}

}  // namespace

std::string recordingFault(Bytes input) {
  ByteSource bytes(input);
  if (bytes.flag()) return faultOf(recorded(bytes), true);
  if (bytes.flag()) return faultOf(forged(bytes), false);
  return faultOf(bytes.remaining(), false);
}

}  // namespace platon::fuzz
