#pragma once

#include <string_view>

#include "tests/exactness/oracle/trace/trace.h"

namespace platon::oracle {

/// Parses a line of a trace. Throws JsonError unless every key of the format occurs exactly once, every value has its
/// type and every coordinate is below 2^29. Does not check what the numbers mean.
TraceHeader readTraceHeader(std::string_view line);
TraceTick readTraceTick(std::string_view line);

}  // namespace platon::oracle
