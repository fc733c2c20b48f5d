#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>

#include "platon/exact/integer.h"
#include "platon/physics/sweep.h"
#include "tests/sim/commands.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {
namespace {

class BadLine : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads the numbers of one query.
class Numbers {
 public:
  explicit Numbers(std::string_view line) : rest_(line) { skipSpace(); }

  std::int64_t next(std::int64_t low, std::int64_t high, const char* what) {
    if (rest_.empty()) throw BadLine(std::string("the line ends before ") + what);
    const std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r"));
    const auto number = wholeNumber(word, low, high);
    if (!number) {
      throw BadLine("'" + std::string(word.substr(0, 32)) + "' is not valid as " + what +
                    ": expected an integer from " + std::to_string(low) + " to " + std::to_string(high));
    }
    rest_.remove_prefix(word.size());
    skipSpace();
    return *number;
  }
  Point point(const char* what) {
    const auto x = next(-kCoordinateLimit + 1, kCoordinateLimit - 1, what);
    const auto y = next(-kCoordinateLimit + 1, kCoordinateLimit - 1, what);
    return {static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)};
  }
  bool empty() const { return rest_.empty(); }

 private:
  void skipSpace() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r"), rest_.size())); }

  std::string_view rest_;
};

void answer(const std::optional<Hit>& hit) {
  if (!hit) {
    std::puts("miss");
    return;
  }
  std::printf("hit %lld %lld %d %d\n", static_cast<long long>(hit->time.numerator),
              static_cast<long long>(hit->time.denominator), hit->normal.x, hit->normal.y);
}

void query(const std::string& line, Sweep& sweep) {
  Numbers numbers(line);
  const auto count = numbers.next(3, 1 << 20, "the number of vertices");
  std::vector<Point> vertices;
  for (std::int64_t i = 0; i < count; ++i) vertices.push_back(numbers.point("a vertex coordinate"));
  const Point position = numbers.point("a coordinate of the position");
  const Point displacement = numbers.point("a coordinate of the displacement");
  const Point a = numbers.point("a coordinate of the segment");
  const Point b = numbers.point("a coordinate of the segment");
  if (!numbers.empty()) throw BadLine("unexpected text after the query");
  if (const auto reason = Convex::fault(vertices)) throw BadLine(*reason);
  const Convex shape(std::move(vertices));
  sweep.start(shape, position, displacement);
  answer(sweep.against({a, b}));
}

}  // namespace

int sweepCommand(const std::vector<std::string>& arguments) {
  const Options options(arguments, {}, {});
  if (!options.positionals().empty()) throw UsageError("platon-sim sweep takes no arguments; it reads standard input");
  std::ios::sync_with_stdio(false);
  Sweep sweep;
  bool valid = true;
  std::string line;
  for (long number = 1; std::getline(std::cin, line); ++number) {
    try {
      query(line, sweep);
    } catch (const BadLine& reason) {
      std::fprintf(stderr, "line %ld: %s\n", number, reason.what());
      valid = false;
    }
  }
  return valid ? 0 : 3;
}

}  // namespace platon::sim
