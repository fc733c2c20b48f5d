#pragma once

#include <cstddef>

// Programs that link platon_counted_heap count what they allocate by operator new, for one thread.
namespace platon {

/// Number of calls of operator new so far.
std::size_t allocations();

/// Bytes in use that came from operator new, exactly.
std::size_t allocatedBytes();

}  // namespace platon
