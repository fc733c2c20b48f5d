#include "tests/exactness/reference/course.h"

#include <algorithm>

namespace platon::reference {
namespace {

constexpr double kMargin = 1;

}  // namespace

double quotient(const mpz_class& numerator, const mpz_class& denominator) {
  return mpq_class(numerator, denominator).get_d();
}

Reach::Reach(const Place& from, double x, double y) {
  const double fromX = quotient(from.x, from.d);
  const double fromY = quotient(from.y, from.d);
  lowX = std::min(fromX, fromX + x) - kMargin;
  lowY = std::min(fromY, fromY + y) - kMargin;
  highX = std::max(fromX, fromX + x) + kMargin;
  highY = std::max(fromY, fromY + y) + kMargin;
}

Reach::Reach(const oracle::Box& box)
    : lowX(static_cast<double>(box.low.x)),
      lowY(static_cast<double>(box.low.y)),
      highX(static_cast<double>(box.high.x)),
      highY(static_cast<double>(box.high.y)) {}

Course::Course(const ExactScene& scene)
    : velocityX_(static_cast<double>(scene.velocity.x)), velocityY_(static_cast<double>(scene.velocity.y)) {
  obstacles_.reserve(scene.lines.size());
  for (const oracle::Segment& line : scene.lines) {
    const PathObstacle& obstacle = obstacles_.emplace_back(scene.shape, line);
    const auto [low, high] = along(boxes_.emplace_back(obstacle.box));
    order_.emplace_back(low, order_.size());
    longest_ = std::max(longest_, high - low);
  }
  std::sort(order_.begin(), order_.end());
}

std::pair<double, double> Course::along(const Reach& reach) const {
  const auto [lowX, highX] = std::minmax({velocityX_ * reach.lowX, velocityX_ * reach.highX});
  const auto [lowY, highY] = std::minmax({velocityY_ * reach.lowY, velocityY_ * reach.highY});
  return {lowX + lowY, highX + highY};
}

std::vector<std::size_t> Course::near(const Reach& reach) const {
  const auto [low, high] = along(reach);
  std::vector<std::size_t> found;
  auto next = std::lower_bound(order_.begin(), order_.end(), std::pair(low - longest_, std::size_t{0}));
  for (; next != order_.end() && next->first <= high; ++next) {
    if (reach.touches(boxes_[next->second])) found.push_back(next->second);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace platon::reference
