#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tests/exactness/oracle/exact_geometry.h"

namespace platon::oracle {

/// One question of the sweep query format: when does the open polygon `shape`, standing at `position` and moving by
/// `displacement` during t = 0 … 1, first meet `obstacle`?
struct SweepQuery {
  Polygon shape;
  Vec position;
  Vec displacement;
  Segment obstacle;
};

/// True when the question is well formed: strictly convex, counter-clockwise, every number below 2^29 in magnitude.
bool isValid(const SweepQuery& query);

/// The question as one line without its line feed.
std::string toLine(const SweepQuery& query);

/// What a program answered.
struct SweepAnswer {
  bool hit = false;
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  Vec normal;
};

/// Reads `miss` or `hit N D nx ny`; nothing when the line is neither to the letter.
std::optional<SweepAnswer> parseAnswer(std::string_view line);

}  // namespace platon::oracle
