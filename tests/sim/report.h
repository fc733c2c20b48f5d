#pragma once

#include <exception>

namespace platon::sim {

/// Prints the error to stderr and returns the exit code of the program: 2 for a UsageError, 3 for an InputError and for
/// an exception of the simulation.
int report(const std::exception& error);

}  // namespace platon::sim
