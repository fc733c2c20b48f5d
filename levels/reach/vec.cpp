#include "levels/reach/vec.h"

namespace platon {
namespace {

double distance(Vec point, const Rect& rect) {
  const double x = std::max({rect.low.x - point.x, 0.0, point.x - rect.high.x});
  const double y = std::max({rect.low.y - point.y, 0.0, point.y - rect.high.y});
  return std::hypot(x, y);
}

// Whether the line meets the rectangle (Liang and Barsky, 1984).
bool meets(const Rect& rect, const Line& line) {
  const Vec along = line.b - line.a;
  double enter = 0;
  double leave = 1;
  const auto clip = [&](double speed, double gap) {  // speed * t <= gap
    if (speed == 0) return gap >= 0;
    if (speed < 0) enter = std::max(enter, gap / speed);
    if (speed > 0) leave = std::min(leave, gap / speed);
    return enter <= leave;
  };
  return clip(along.x, rect.high.x - line.a.x) && clip(-along.x, line.a.x - rect.low.x) &&
         clip(along.y, rect.high.y - line.a.y) && clip(-along.y, line.a.y - rect.low.y);
}

}  // namespace

Rect boundsOf(const Line& line, Vec margin) {
  return {Vec{std::min(line.a.x, line.b.x), std::min(line.a.y, line.b.y)} - margin,
          Vec{std::max(line.a.x, line.b.x), std::max(line.a.y, line.b.y)} + margin};
}

double distance(Vec point, const Line& line) {
  const Vec along = line.b - line.a;
  const double squared = dot(along, along);
  const double t = squared == 0 ? 0 : std::clamp(dot(point - line.a, along) / squared, 0.0, 1.0);
  return length(point - (line.a + along * t));
}

// The nearest points of two convex sets that do not meet: one of them is a vertex.
double distance(const Rect& rect, const Line& line) {
  if (meets(rect, line)) return 0;
  const double ends = std::min(distance(line.a, rect), distance(line.b, rect));
  const double low = std::min(distance(rect.low, line), distance(Vec{rect.high.x, rect.low.y}, line));
  const double high = std::min(distance(rect.high, line), distance(Vec{rect.low.x, rect.high.y}, line));
  return std::min({ends, low, high});
}

}  // namespace platon
