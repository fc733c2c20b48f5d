#include "protocol/assembly.h"

namespace platon {

bool Assembly::add(std::uint32_t total, std::uint32_t offset, std::span<const std::uint8_t> chunk) {
  if (offset == 0) {
    clear();
    total_ = total;
  }
  const bool inOrder = total == total_ && offset == bytes_.size() && chunk.size() <= total - bytes_.size();
  if (!inOrder || chunk.empty()) {
    clear();
    return false;
  }
  bytes_.insert(bytes_.end(), chunk.begin(), chunk.end());
  return bytes_.size() == total_;
}

void Assembly::clear() {
  bytes_.clear();
  total_ = 0;
}

}  // namespace platon
