#pragma once

#include <exception>

namespace platon::sim {

/// Says on stderr why the program ends, and returns its exit code: 2 after a UsageError, 3 after anything else, which
/// is an InputError or a refusal by the simulation.
int report(const std::exception& reason);

}  // namespace platon::sim
