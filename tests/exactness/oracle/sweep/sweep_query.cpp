#include "tests/exactness/oracle/sweep/sweep_query.h"

#include <algorithm>
#include <charconv>

namespace platon::oracle {
namespace {

bool isInRange(Vec v) {
  const auto fits = [](std::int64_t value) { return value > -kCoordinateLimit && value < kCoordinateLimit; };
  return fits(v.x) && fits(v.y);
}

void append(std::string& line, std::int64_t number) {
  char text[24];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  line.append(" ").append(text, end);
}

void append(std::string& line, Vec v) {
  append(line, v.x);
  append(line, v.y);
}

/// Removes " NUMBER" from the front of `text`.
bool take(std::string_view& text, std::int64_t& number) {
  if (text.empty() || text.front() != ' ') return false;
  text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace

bool isValid(const SweepQuery& query) {
  return isInRange(query.position) && isInRange(query.displacement) && isInRange(query.segment.a) &&
         isInRange(query.segment.b) && std::all_of(query.shape.begin(), query.shape.end(), isInRange) &&
         isStrictlyConvex(query.shape);
}

std::string toLine(const SweepQuery& query) {
  std::string line = std::to_string(query.shape.size());
  for (const Vec vertex : query.shape) append(line, vertex);
  for (const Vec v : {query.position, query.displacement, query.segment.a, query.segment.b}) append(line, v);
  return line;
}

std::optional<SweepAnswer> parseAnswer(std::string_view line) {
  if (line == "miss") return SweepAnswer{};
  if (!line.starts_with("hit")) return std::nullopt;
  line.remove_prefix(3);
  SweepAnswer answer{true, 0, 1, {}};
  const bool complete = take(line, answer.numerator) && take(line, answer.denominator) && take(line, answer.normal.x) &&
                        take(line, answer.normal.y) && line.empty();
  return complete ? std::optional(answer) : std::nullopt;
}

}  // namespace platon::oracle
