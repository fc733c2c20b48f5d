#include "client/session/known_levels.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "protocol/limits.h"

namespace platon {

KnownLevels::KnownLevels(std::vector<std::shared_ptr<const Level>> levels, std::shared_ptr<LevelStore> store)
    : levels_(std::move(levels)), store_(std::move(store)) {
  for (const auto& level : levels_) announced_.push_back(level->hash);
  for (const std::uint64_t hash : store_ ? store_->newest(kMaxLevelsKnown) : std::vector<std::uint64_t>()) {
    const bool isNew = std::find(announced_.begin(), announced_.end(), hash) == announced_.end();
    if (isNew && announced_.size() < kMaxLevelsKnown) announced_.push_back(hash);
  }
}

std::shared_ptr<const Level> KnownLevels::find(std::uint64_t hash, WorkLimit& work) {
  const auto found =
      std::find_if(levels_.begin(), levels_.end(), [hash](const auto& known) { return known->hash == hash; });
  if (found != levels_.end()) return *found;
  std::shared_ptr<const Level> stored = store_ ? store_->load(hash) : nullptr;
  if (stored) {
    work.addStore();
    work.addBytes(stored->text.size());
    remember(stored);
  }
  return stored;
}

void KnownLevels::expectFirst(std::uint64_t hash, WorkLimit& work) {
  const bool announced = std::find(announced_.begin(), announced_.end(), hash) != announced_.end();
  if (!announced && !find(hash, work)) requested_ = hash;
}

bool KnownLevels::request(std::uint64_t hash) {
  if (unanswered_ == kMaxUnansweredRequests) return false;
  ++unanswered_;
  requested_ = hash;
  text_.clear();
  return true;
}

KnownLevels::Receipt KnownLevels::receive(const LevelChunk& message, WorkLimit& work) {
  if (message.hash != requested_ || !text_.add(message.total, message.offset, message.bytes)) return Receipt::kNone;
  const std::vector<std::uint8_t>& bytes = text_.bytes();
  LevelResult result = loadLevel(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  work.addMessage();
  work.addBytes(bytes.size());
  requested_.reset();
  text_.clear();
  unanswered_ = 0;
  if (!result.level || result.level->hash != message.hash) return Receipt::kInvalid;
  if (store_) {
    work.addStore();
    store_->keep(*result.level);
  }
  remember(std::move(result.level));
  return Receipt::kLevel;
}

void KnownLevels::remember(std::shared_ptr<const Level> level) {
  if (levels_.size() == kMaxLevelsKnown) levels_.erase(levels_.begin());
  levels_.push_back(std::move(level));
}

}  // namespace platon
