#pragma once

#include <string>

namespace platon::hard_cases {

/// Expects that `Sweep` answers each query of NAME.queries, in all eight symmetries of the lattice, with the same line
/// of NAME.answers. The oracle must agree with the file, and its answer must satisfy the definition. `platon-sim sweep
/// < NAME.queries` prints NAME.answers. Returns the number of queries.
std::size_t expectAnswers(const std::string& name);

}  // namespace platon::hard_cases
