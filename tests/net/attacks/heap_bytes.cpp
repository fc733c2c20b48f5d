// Counts what is allocated: with the functions of glibc, which every allocation of the process ends in. The statistics
// of glibc itself (mallinfo) take what its caches keep for allocated. The sanitizers replace the same functions, and
// count.
#include "tests/net/attacks/heap_bytes.h"

#include <atomic>
#include <cerrno>
#include <cstddef>

#ifdef PLATON_SANITIZE

extern "C" std::size_t __sanitizer_get_current_allocated_bytes();

namespace platon {

std::int64_t heapBytes() { return static_cast<std::int64_t>(__sanitizer_get_current_allocated_bytes()); }

}  // namespace platon

#else

#include <malloc.h>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);
}

namespace {

std::atomic<std::int64_t> allocated = 0;

void* counted(void* memory) {
  allocated += static_cast<std::int64_t>(malloc_usable_size(memory));
  return memory;
}

void discount(void* memory) { allocated -= static_cast<std::int64_t>(malloc_usable_size(memory)); }

}  // namespace

extern "C" {

void* malloc(std::size_t size) { return counted(__libc_malloc(size)); }

void* calloc(std::size_t count, std::size_t size) { return counted(__libc_calloc(count, size)); }

void* realloc(void* memory, std::size_t size) {
  discount(memory);
  return counted(__libc_realloc(memory, size));
}

void* memalign(std::size_t alignment, std::size_t size) { return counted(__libc_memalign(alignment, size)); }

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

void free(void* memory) {
  discount(memory);
  __libc_free(memory);
}

}  // extern "C"

namespace platon {

std::int64_t heapBytes() { return allocated; }

}  // namespace platon

#endif
