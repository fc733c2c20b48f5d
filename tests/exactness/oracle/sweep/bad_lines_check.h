#pragma once

#include "tests/exactness/oracle/sweep/sweep_program.h"

namespace platon::oracle {

/// Feeds the program one malformed line after another and empty input. Each must be refused by its line number with a
/// reason and exit code 3, empty input be answered with nothing. Prints every disagreement; returns their count.
int countBadLineFailures(const SweepProgram& program);

}  // namespace platon::oracle
