#include "server/match/played_round.h"

namespace platon {

void MatchRecorder::begin(std::uint32_t round, const Game& game) {
  if (recorder_) return;
  round_ = round;
  ticks_ = 0;
  recorder_.emplace(game);
}

void MatchRecorder::record(std::span<const Input> inputs, const Game& game, std::uint64_t hash) {
  ++ticks_;
  recorder_->record(inputs, game, hash);
  addPiece(game, false);
}

void MatchRecorder::finish(const Game& game) {
  if (!recorder_) return;
  recorder_->finish(game);
  addPiece(game, true);
  recorder_.reset();
}

void MatchRecorder::addPiece(const Game& game, bool last) {
  if (ticks_ < kMinTicks) return;
  std::vector<std::uint8_t> bytes = recorder_->takeBytes();
  if (bytes.empty()) return;
  pieces_.push_back({round_, game.level().title, game.tick(), last, std::move(bytes)});
}

PlayedRound::PlayedRound(const LevelPointer& level, bool isRecorded)
    : game_(level), history_(number_, shortHash(game_.hash())), isRecorded_(isRecorded) {}

void PlayedRound::start(const LevelPointer& level) {
  endRecording();
  ++number_;
  game_ = Game(level);
  history_ = TickHistory(number_, shortHash(game_.hash()));
}

void PlayedRound::advance(const std::vector<Input>& inputs) {
  if (isRecorded_) recorder_.begin(number_, game_);
  game_.advance(inputs);
  const std::uint64_t hash = game_.hash();
  if (isRecorded_) recorder_.record(inputs, game_, hash);
  history_.append(inputs, shortHash(hash));
}

}  // namespace platon
