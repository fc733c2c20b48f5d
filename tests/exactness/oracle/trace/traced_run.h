#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// What became of a program that wrote a trace.
struct TracedRun {
  TraceReport report;
  int exitCode = 0;
};

/// Runs a program (file name first) with `--trace` and a pipe added, and checks the trace as it comes. The program's
/// other output goes where this one's goes. A trace that cannot be judged ends the program.
TracedRun runTraced(std::vector<std::string> arguments);

}  // namespace platon::oracle
