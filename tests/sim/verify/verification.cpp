#include "tests/sim/verify/verification.h"

namespace platon::sim {

Verifier::Verifier(std::span<const std::uint8_t> recording, std::uint32_t from)
    : reader_(recording), bytes_(recording.size()) {
  start(from);
}

void Verifier::start(std::uint32_t from) {
  block_ = reader_.next();
  if (!block_) return;
  const std::uint32_t first = block_->firstTick;
  if (from < first) from = first;
  while (block_->ticks() != 0 && block_->firstTick + block_->ticks() <= from) {
    auto next = reader_.next();
    if (!next) break;  // truncated: start with the last block
    block_ = std::move(next);
  }
  begin_ = block_->offset;
  beginsLater_ = block_->firstTick != first;
  Game game(reader_.level());
  if (!game.restore(block_->state)) {
    found_.fault = "byte " + std::to_string(block_->offset) + ": the state of the block is not valid on this level";
    return;
  }
  if (game.tick() != block_->firstTick) {
    found_.fault = "byte " + std::to_string(block_->offset) + ": the block begins at tick " +
                   std::to_string(block_->firstTick) + ", but its state is that of tick " + std::to_string(game.tick());
    return;
  }
  found_.firstTick = game.tick();
  found_.beginsInMidGame = game.slots() != 0 || game.openDoors() != 0 || game.over();
  found_.hash = game.hash();
  run_.emplace(game);
  before_ = game;
  game_ = std::move(game);
}

double Verifier::part() const {
  return block_ ? static_cast<double>(block_->offset - begin_) / static_cast<double>(bytes_ - begin_) : 1;
}

Verification Verifier::run(const Played& played) {
  for (; game_ && block_; block_ = reader_.next()) {
    if (!matches(*block_)) break;
    play(*block_, played);
  }
  if (found_.fault.empty()) found_.fault = reader_.fault();
  if (game_) found_.slots = game_->slots();
  found_.run = runFound();
  return found_;
}

std::variant<RunFinish, std::string> Verifier::runFound() const {
  if (!game_ || !found_.fault.empty() || found_.divergence) return "is no run: it was not replayed to its end";
  if (!beginsLater_) return run_->finish(*before_, *game_);
  return "may be a run, which is not known: the replay began at tick " + std::to_string(found_.firstTick);
}

// Compares the states at a checkpoint. After a divergence, also finds the first field that differs.
bool Verifier::matches(const RecordedBlock& block) {
  if (!found_.divergence && game_->save() == block.state) return true;
  Game recorded(reader_.level());
  const bool valid = recorded.restore(block.state);
  if (!found_.divergence) {
    found_.divergence = Divergence{block.firstTick, game_->hash(), valid ? recorded.hash() : 0, {}, {}};
  }
  found_.divergence->comparedAt = block.firstTick;
  if (valid) found_.divergence->difference = firstDifference(*game_, recorded);
  return false;
}

void Verifier::play(const RecordedBlock& block, const Played& played) {
  for (std::uint32_t i = 0; i < block.ticks(); ++i) {
    if (i + 1 == block.ticks()) before_ = game_;
    run_->add(block.inputsOf(i));
    game_->advance(block.inputsOf(i));
    const std::uint64_t hash = game_->hash();
    if (played) played(block.inputsOf(i), *game_);
    if (found_.divergence) continue;
    ++found_.ticks;
    found_.hash = hash;
    if (hash != block.hashes[i]) found_.divergence = Divergence{game_->tick(), hash, block.hashes[i], {}, {}};
  }
}

}  // namespace platon::sim
