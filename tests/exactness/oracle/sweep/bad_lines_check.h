#pragma once

#include "tests/exactness/oracle/sweep/sweep_program.h"

namespace platon::oracle {

/// Runs the program on empty input, which must give no answers, and on many malformed lines. Each malformed line must
/// be refused with exit code 3 and a message that names the line's number and a reason. Prints every failure; returns
/// their number.
int countBadLineFailures(const SweepProgram& program);

}  // namespace platon::oracle
