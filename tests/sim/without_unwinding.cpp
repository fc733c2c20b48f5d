// Exceptions for a C++ library that was built without them, such as Debian's for WebAssembly. No stack is unwound and
// no handler runs: the first throw ends the program with the message and the exit code of main. Everything platon-sim
// throws derives only from std::exception, so that the address of the exception is that of its base.

#include <cstdlib>
#include <exception>
#include <typeinfo>

#include "tests/sim/report.h"

extern "C" {

void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }

void __cxa_free_exception(void* exception) noexcept { std::free(exception); }

[[noreturn]] void __cxa_throw(void* exception, std::type_info*, void (*)(void*)) {
  std::exit(platon::sim::report(*static_cast<const std::exception*>(exception)));
}

}  // extern "C"
