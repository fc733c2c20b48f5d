#include "tests/support/counted_heap.h"

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t kHeader = alignof(std::max_align_t);

std::size_t calls = 0;
std::size_t bytes = 0;

// Keeps the size in front of the memory: that which malloc gives depends on what was freed before.
void* allocateOrNull(std::size_t size) noexcept {
  auto* const memory = static_cast<std::size_t*>(std::malloc(size + kHeader));
  if (memory == nullptr) return nullptr;
  *memory = size;
  ++calls;
  bytes += size;
  return reinterpret_cast<char*>(memory) + kHeader;
}

void* allocate(std::size_t size) {
  if (void* memory = allocateOrNull(size)) return memory;
  throw std::bad_alloc();
}

void release(void* memory) noexcept {
  if (memory == nullptr) return;
  auto* const start = reinterpret_cast<std::size_t*>(static_cast<char*>(memory) - kHeader);
  bytes -= *start;
  std::free(start);
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

namespace platon {

std::size_t allocations() { return calls; }

std::size_t allocatedBytes() { return bytes; }

}  // namespace platon
