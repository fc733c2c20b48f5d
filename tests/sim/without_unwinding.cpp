// Exceptions for a C++ library that was built without them, as Debian's for WebAssembly is: no stack is unwound and no
// handler runs, but the first exception thrown ends the program with the message and the exit code that main would
// give it. What platon-sim throws derives from std::exception alone, so that its address is that of its base.

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
