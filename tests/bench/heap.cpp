#include "tests/bench/heap.h"

#include <malloc.h>

#include <cstdlib>
#include <new>

namespace {

std::size_t calls = 0;
std::size_t bytes = 0;

void* allocateOrNull(std::size_t size) noexcept {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  ++calls;
  bytes += malloc_usable_size(memory);
  return memory;
}

void release(void* memory) noexcept {
  bytes -= malloc_usable_size(memory);
  std::free(memory);
}

void* allocate(std::size_t size) {
  if (void* memory = allocateOrNull(size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// All forms: by default the others call the first, but the address sanitizer replaces each that is not replaced here.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocateOrNull(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocateOrNull(size); }
void operator delete(void* memory) noexcept { release(memory); }
void operator delete[](void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete[](void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { release(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { release(memory); }

namespace platon::bench {

std::size_t heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

std::size_t allocations() { return calls; }

std::size_t allocatedBytes() { return bytes; }

}  // namespace platon::bench
