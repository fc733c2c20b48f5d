#pragma once

#include <string>

namespace platon::hard_cases {

/// Asks every query of the file NAME.queries, and whatever becomes of it by the eight symmetries of the lattice: the
/// answer must be that of the same line of NAME.answers, and so says the oracle, in two ways.
/// `platon-sim sweep < NAME.queries` gives NAME.answers to the letter. Returns the number of queries in the file.
std::size_t expectAnswers(const std::string& name);

}  // namespace platon::hard_cases
