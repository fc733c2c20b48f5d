#include "levels/solve/recorded_way.h"

#include "platon/game/recorder.h"
#include "platon/game/recording_reader.h"

namespace platon {

RecordedWay readRecordedWay(std::span<const std::uint8_t> recording) {
  RecordedWay way;
  RecordingReader reader(recording);
  while (const auto block = reader.next()) {
    for (std::uint32_t tick = 0; tick < block->ticks(); ++tick) {
      const auto inputs = block->inputsOf(tick);
      way.inputs.emplace_back(inputs.begin(), inputs.end());
    }
  }
  if (reader.state() == RecordingReader::State::kComplete) {
    way.level = reader.level();
  } else {
    way.fault = reader.fault().empty() ? "the recording is cut off" : reader.fault();
  }
  return way;
}

std::vector<std::uint8_t> recordWay(const std::shared_ptr<const Level>& level, const Solution& inputs) {
  Game game(level);
  Recorder recorder(game);
  for (const std::vector<Input>& tick : inputs) {
    game.advance(tick);
    recorder.record(tick, game);
  }
  recorder.finish(game);
  return recorder.takeBytes();
}

}  // namespace platon
