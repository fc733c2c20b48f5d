#include "platon/game/recorder.h"

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "shared/exact/hash.h"

namespace platon {

namespace {

std::vector<std::uint8_t> headOf(const Level& level) {
  const std::string& text = level.text;
  StateWriter head;
  head.append(kRecordingMagic);
  head.add(kRulesVersion);
  head.add(static_cast<std::uint32_t>(text.size()));
  head.add(~static_cast<std::uint32_t>(text.size()));
  head.append(text);
  head.add(hashOf(head.bytes()));
  return head.take();
}

}  // namespace

Recorder::Recorder(const Game& start, std::uint32_t checkpointTicks)
    : checkpointTicks_(checkpointTicks), level_(start.sharedLevel()), firstTick_(start.tick()), state_(start.save()) {
  assert(checkpointTicks >= 1 && checkpointTicks <= kMaxCheckpointTicks);
}

std::vector<std::uint8_t> Recorder::takeBytes() {
  std::vector<std::uint8_t> bytes = std::exchange(bytes_, {});
  const std::shared_ptr<const Level> level = std::exchange(level_, nullptr);
  if (!level) return bytes;
  std::vector<std::uint8_t> all = headOf(*level);
  all.insert(all.end(), bytes.begin(), bytes.end());
  return all;
}

void Recorder::record(std::span<const Input> inputs, const Game& game, std::uint64_t hash) {
  inputs_.emplace_back(inputs.begin(), inputs.end());
  hashes_.push_back(hash);
  if (hashes_.size() == checkpointTicks_) addBlock(game);
}

void Recorder::finish(const Game& game) {
  if (!hashes_.empty()) addBlock(game);
  addBlock(game);
}

// Appends the block to bytes_ and begins the next one.
void Recorder::addBlock(const Game& game) {
  std::size_t slots = 0;
  for (const auto& inputs : inputs_) slots = std::max(slots, inputs.size());
  StateWriter body;
  body.add(firstTick_);
  body.add(static_cast<std::uint16_t>(hashes_.size()));
  body.add(static_cast<std::uint16_t>(slots));
  body.add(static_cast<std::uint32_t>(state_.size()));
  body.append(state_);
  for (std::uint32_t slot = 0; slot < slots; ++slot) addRuns(body, slot);
  for (const std::uint64_t hash : hashes_) body.add(hash);

  StateWriter block;
  const auto length = static_cast<std::uint32_t>(body.bytes().size());
  block.add(length);
  block.add(~length);
  block.append(body.bytes());
  block.add(hashOf(body.bytes()));
  bytes_.insert(bytes_.end(), block.bytes().begin(), block.bytes().end());

  firstTick_ = game.tick();
  state_ = game.save();
  inputs_.clear();
  hashes_.clear();
}

void Recorder::addRuns(StateWriter& body, std::uint32_t slot) const {
  const auto inputAt = [&](std::size_t tick) { return slot < inputs_[tick].size() ? inputs_[tick][slot] : Input{}; };
  for (std::size_t tick = 0; tick < inputs_.size();) {
    const std::size_t start = tick;
    while (tick < inputs_.size() && inputAt(tick) == inputAt(start)) ++tick;
    body.add(static_cast<std::uint16_t>(tick - start));
    body.add(inputAt(start).buttons);
  }
}

}  // namespace platon
