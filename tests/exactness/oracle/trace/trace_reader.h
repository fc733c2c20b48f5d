#pragma once

#include <string_view>

#include "tests/exactness/oracle/trace/trace.h"

namespace platon::oracle {

/// Reads a line of a trace to the letter: every key of the format once, no other, every value of its type, every
/// coordinate below 2^29. Throws JsonError. What the numbers mean is not looked at.
TraceHeader readTraceHeader(std::string_view line);
TraceTick readTraceTick(std::string_view line);

}  // namespace platon::oracle
