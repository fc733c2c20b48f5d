#include "tests/exactness/reference/simulated_body.h"

#include <cmath>
#include <span>

#include "platon/exact/precise_point.h"
#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "platon/physics/step_observer.h"
#include "tests/exactness/step_check/conversions.h"

namespace platon::reference {
namespace {

using step_check::toPoint;

class LegCounter : public StepObserver {
 public:
  void leg(std::uint32_t, std::span<const InstanceView>) override { ++legs; }
  std::int64_t legs = -1;  // the observer is also called at the start of the step
};

}  // namespace

SimulatedBody::SimulatedBody(const ExactScene& scene) : velocity_(toPoint(scene.velocity)) {
  MapPart part(world_, 0);
  for (const oracle::Segment& line : scene.lines) part.line(toPoint(line.a), toPoint(line.b));
  part.initialize();
  Entity entity(world_, Convex(step_check::toPoints(scene.shape)));
  part.insert(entity, toPoint(scene.start), Angle());
}

void SimulatedBody::tick() {
  LegCounter counter;
  Entity(world_, 0).setVelocity(velocity_);
  world_.solve(&counter);
  legs_ += counter.legs;
}

RationalVec SimulatedBody::position() const {
  const Point at = world_.entities()[0].position;
  return {mpq_class(at.x), mpq_class(at.y)};
}

RationalVec SimulatedBody::precisePosition() const {
  const auto& state = world_.entities()[0];
  const mpq_class one(static_cast<long>(PrecisePoint::kOne));
  return {state.position.x + static_cast<long>(state.remainder.x) / one,
          state.position.y + static_cast<long>(state.remainder.y) / one};
}

double distance(const RationalVec& a, const RationalVec& b) {
  const mpq_class dx = a.x - b.x;
  const mpq_class dy = a.y - b.y;
  return std::hypot(dx.get_d(), dy.get_d());
}

}  // namespace platon::reference
