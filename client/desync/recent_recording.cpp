#include "client/desync/recent_recording.h"

#include <utility>

namespace platon {

RecentRecording::RecentRecording(const Game& start)
    : recorder_(start, kTicksBetweenCheckpoints), header_(recorder_.takeBytes()) {}

void RecentRecording::record(std::span<const Input> inputs, const Game& game) {
  recorder_.record(inputs, game);
  std::vector<std::uint8_t> block = recorder_.takeBytes();
  if (block.empty()) return;
  blockBytes_ += block.size();
  blocks_.push_back(std::move(block));
  for (; blockBytes_ > kMaxBytes && blocks_.size() > 1; blocks_.pop_front()) blockBytes_ -= blocks_.front().size();
}

std::vector<std::uint8_t> RecentRecording::finish(const Game& game) {
  recorder_.finish(game);
  blocks_.push_back(recorder_.takeBytes());
  std::vector<std::uint8_t> whole = header_;
  for (const auto& block : blocks_) whole.insert(whole.end(), block.begin(), block.end());
  return whole;
}

}  // namespace platon
