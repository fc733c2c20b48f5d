#include "client/replay/recording_facts.h"

#include <span>
#include <utility>
#include <variant>

#include "client/replay/recording_fault.h"
#include "client/replay/recording_head.h"
#include "client/replay/replay.h"
#include "client/replay/replay_file.h"
#include "platon/game/game.h"
#include "platon/game/recording_reader.h"

namespace platon {
namespace {

constexpr const char* kDamagedEnd = "is a damaged recording: its end does not give the recorded game";

// The end of a recording: its last block with ticks, and the state after it.
struct Ending {
  RecordedBlock block;
  std::vector<std::uint8_t> state;
  std::optional<RecordedRun> run;  // with the inputs of the whole recording; nothing: there is no tick
};

// Reads to the end. Notes why that is impossible.
Ending readEnding(RecordingReader& reader, std::string& note, const std::stop_token& stop) {
  Ending ending;
  std::optional<RecordedBlock> block = reader.next();
  if (!block) return ending;
  const std::optional<Game> start = gameBefore(*block, reader.level());
  if (!start) return note = Replay::kNoStart, ending;
  PlayCost cost(*start);
  for (; block && note.empty() && !stop.stop_requested(); block = reader.next()) {
    if (!cost.add(block->ticks(), block->slots)) note = Replay::kTooLong;
    if (block->ticks() != 0 && !ending.run) ending.run.emplace(*start);
    for (std::uint32_t tick = 0; tick < block->ticks(); ++tick) ending.run->add(block->inputsOf(tick));
    ending.state = block->state;
    if (block->ticks() != 0) ending.block = std::move(*block);
  }
  return ending;
}

// Plays the last block. Gives the time of the run, if it is one.
void playEnding(const std::shared_ptr<const Level>& level, const Ending& ending, RecordingFacts& facts,
                const std::stop_token& stop) {
  if (!ending.run) return;
  Game game(level);
  bool agrees = game.restore(ending.block.state) && game.tick() == ending.block.firstTick;
  const std::uint32_t last = ending.block.ticks() - 1;
  for (std::uint32_t tick = 0; agrees && tick < last; ++tick) {
    if (stop.stop_requested()) return;
    game.advance(ending.block.inputsOf(tick));
  }
  const Game before = game;
  if (agrees) game.advance(ending.block.inputsOf(last));
  agrees = agrees && game.save() == ending.state;
  if (!agrees) facts.note = kDamagedEnd;
  if (!agrees) return;
  const auto run = ending.run->finish(before, game);
  if (const auto* const finish = std::get_if<RunFinish>(&run)) {
    facts.ticks = finish->ticks;
  } else {
    facts.noRun = std::get<std::string>(run);
  }
}

}  // namespace

RecordingFacts readRecordingFacts(const std::filesystem::path& file, const std::stop_token& stop) {
  RecordingFacts facts;
  const RecordingBytes read = readRecordingBytes(file, stop);
  facts.note = read.fault;
  if (!facts.note.empty()) return facts;
  const auto bytes = read.bytes();
  RecordingReader reader(bytes);
  const std::optional<RecordingHead> head = readRecordingHead(bytes);
  if (!head) {
    const bool isCut = reader.state() == RecordingReader::State::kTruncated;
    facts.note = isCut ? recordingFault(reader, bytes) : "is not a recording";
    return facts;
  }
  facts.rules = head->rules;
  facts.level = head->level;
  const Ending ending = readEnding(reader, facts.note, stop);
  if (stop.stop_requested()) return facts;
  if (facts.note.empty()) facts.note = recordingFault(reader, bytes);
  if (facts.note.empty()) playEnding(head->level, ending, facts, stop);
  return facts;
}

}  // namespace platon
