#include "tests/exactness/oracle/trace/move_count.h"

#include "tests/exactness/oracle/trace/state_checker.h"

namespace platon::oracle {

std::size_t movesOf(const std::vector<TraceLeg>& legs) {
  std::size_t moves = 0;
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const TraceInstance* before = homeOf(legs[i - 1]);
    const TraceInstance* after = homeOf(legs[i]);
    if (before != nullptr && after != nullptr && before->id == after->id && before->position != after->position)
      ++moves;
  }
  return moves;
}

}  // namespace platon::oracle
