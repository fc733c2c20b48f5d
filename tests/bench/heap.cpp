#include "tests/bench/heap.h"

#include <malloc.h>

namespace platon::bench {

std::size_t heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

}  // namespace platon::bench
