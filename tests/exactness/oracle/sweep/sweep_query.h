#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// A query of the sweep query format: when does the open polygon `shape`, moving from `position` by `displacement`
/// during t = 0 … 1, first hit `segment`?
struct SweepQuery {
  Polygon shape;
  Vec position;
  Vec displacement;
  Segment segment;
};

/// True if the shape is strictly convex and counter-clockwise and every number is below 2^29 in magnitude.
bool isValid(const SweepQuery& query);

/// The query as a line, without the line feed.
std::string toLine(const SweepQuery& query);

/// The answer of a program.
struct SweepAnswer {
  bool hit = false;
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  Vec normal;
};

/// Parses `miss` or `hit N D nx ny`; nothing if the line is not exactly one of these.
std::optional<SweepAnswer> parseAnswer(std::string_view line);

}  // namespace platon::oracle
