#include "server/match/level_rotation.h"

#include <algorithm>
#include <cassert>

namespace platon {

LevelRotation::LevelRotation(std::vector<LevelPointer> levels, Start start) : levels_(std::move(levels)) {
  assert(!levels_.empty());
  advance(start == Start::kFirst ? levels_.front()->players : 1);
}

std::size_t LevelRotation::placeOfNext(std::size_t players) const {
  for (std::size_t i = 0; i < levels_.size(); ++i) {
    const std::size_t place = (next_ + i) % levels_.size();
    if (levels_[place]->players <= std::max<std::size_t>(players, 1)) return place;
  }
  return next_;
}

void LevelRotation::advance(std::size_t players) {
  const std::size_t place = placeOfNext(players);
  current_ = levels_[place];
  next_ = (place + 1) % levels_.size();
}

void LevelRotation::replace(std::vector<LevelPointer> levels) {
  assert(!levels.empty());
  levels_ = std::move(levels);
  next_ = 0;
}

void LevelRotation::update(std::vector<LevelPointer> levels) {
  assert(levels.size() == levels_.size());
  levels_ = std::move(levels);
}

LevelPointer LevelRotation::find(std::uint64_t hash) const {
  if (current_->hash == hash) return current_;
  const auto found = std::find_if(levels_.begin(), levels_.end(), [hash](const auto& l) { return l->hash == hash; });
  return found == levels_.end() ? nullptr : *found;
}

}  // namespace platon
