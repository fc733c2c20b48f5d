#pragma once

#include <string>
#include <vector>

#include "tests/exactness/oracle/trace/trace_report.h"

namespace platon::oracle {

/// Result of a program that wrote a trace.
struct TracedRun {
  TraceReport report;
  int exitCode = 0;
};

/// Runs a program with `--trace PIPE` added to its arguments, the first of which is its file name, and checks the trace
/// while it is written. Other output of the program goes to the standard output and error of the caller. Closes the
/// pipe if the trace cannot be checked further.
TracedRun runTraced(std::vector<std::string> arguments);

}  // namespace platon::oracle
