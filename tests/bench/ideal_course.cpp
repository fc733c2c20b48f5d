#include "tests/bench/ideal_course.h"

#include <utility>

#include "tests/exactness/step_check/conversions.h"

namespace platon::bench {

Scene toScene(const reference::ExactScene& exact) {
  Scene scene{
      .segments = {}, .shape = Convex(step_check::toPoints(exact.shape)), .bodies = {step_check::toPoint(exact.start)}};
  for (const oracle::Segment& line : exact.lines) scene.segments.push_back(step_check::toSegment(line));
  return scene;
}

Place velocityOf(const reference::ExactScene& exact) {
  return {static_cast<double>(exact.velocity.x), static_cast<double>(exact.velocity.y)};
}

std::vector<Place> idealTrajectory(const reference::IdealPath& path, std::int64_t ticks) {
  std::vector<Place> trajectory;
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    const reference::RationalVec at = path.positionAt(tick);
    trajectory.push_back({at.x.get_d(), at.y.get_d()});
  }
  return trajectory;
}

}  // namespace platon::bench
