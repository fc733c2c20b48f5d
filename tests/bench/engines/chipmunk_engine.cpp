// Chipmunk 7. It has no continuous collision detection; for fast bodies its manual recommends thicker segments and
// smaller steps. Each tick is divided so that the fastest body moves less than half its radius per step, and segments
// get a radius of Chipmunk's slop.
#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "tests/bench/engines/engine.h"

namespace platon::bench {
namespace {

constexpr cpFloat kSlop = 0.005;      // metres; Chipmunk lets shapes overlap by the slop
constexpr cpFloat kSleepAfter = 0.5;  // seconds, as in Box2D

cpFloat metres(double subunits) { return subunits / kSubunitsPerMetre; }

cpVect metres(Point point) { return {metres(point.x), metres(point.y)}; }

// What the caller wants of a body, in metres per second. `jumps` is reset by the step that begins the jump.
struct Wanted {
  cpVect velocity;
  bool jumps = false;
};

class ChipmunkEngine : public Engine {
 public:
  explicit ChipmunkEngine(const Scene& scene) : hasGravity_(scene.gravity > 0), space_(cpSpaceNew(), &cpSpaceFree) {
    const Box& bounds = scene.shape.bounds();
    if (hasGravity_) {
      cpSpaceSetGravity(space_.get(), {0, -metres(scene.gravity * kStepsPerSecond * kStepsPerSecond)});
      cpSpaceSetSleepTimeThreshold(space_.get(), kSleepAfter);
    }
    cpSpaceSetCollisionSlop(space_.get(), kSlop);
    radius_ = metres(std::min(bounds.high.x - bounds.low.x, bounds.high.y - bounds.low.y)) / 2;
    for (const Segment& line : scene.segments) {
      keep(cpSegmentShapeNew(cpSpaceGetStaticBody(space_.get()), metres(line.a), metres(line.b), kSlop));
    }
    std::vector<cpVect> vertices;
    for (const Point vertex : scene.shape.vertices()) vertices.push_back(metres(vertex));
    wanted_.resize(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) addBody(vertices, scene.bodies[i], wanted_[i]);
  }
  ~ChipmunkEngine() override {
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_.get(), shape);
      cpShapeFree(shape);
    }
    for (cpBody* body : bodies_) {
      cpSpaceRemoveBody(space_.get(), body);
      cpBodyFree(body);
    }
  }
  ChipmunkEngine(const ChipmunkEngine&) = delete;
  ChipmunkEngine& operator=(const ChipmunkEngine&) = delete;

  void setVelocity(std::size_t body, Place velocity) override {
    const cpVect wanted = {metres(velocity.x * kStepsPerSecond), metres(velocity.y * kStepsPerSecond)};
    wanted_[body] = {wanted, velocity.y != 0};
    fastest_ = std::max(fastest_, cpvlength(wanted) / kStepsPerSecond);
    if (!hasGravity_) return;
    cpBodySetVelocityUpdateFunc(bodies_[body], &walk);
    if (cpBodyIsSleeping(bodies_[body])) cpBodyActivate(bodies_[body]);
  }
  void step() override {
    const int steps = std::max(1, static_cast<int>(std::ceil(fastest_ / (radius_ / 2))));
    for (int i = 0; i < steps; ++i) cpSpaceStep(space_.get(), 1 / kStepsPerSecond / steps);
    fastest_ = 0;
  }
  Place position(std::size_t body) const override {
    const cpVect position = cpBodyGetPosition(bodies_[body]);
    return {position.x * kSubunitsPerMetre, position.y * kSubunitsPerMetre};
  }

 private:
  void keep(cpShape* shape) {
    cpShapeSetFriction(shape, 0);
    cpShapeSetElasticity(shape, 0);
    shapes_.push_back(cpSpaceAddShape(space_.get(), shape));
  }
  // Chipmunk moves bodies before it detects collisions. These callbacks set the velocity between these two stages, so
  // that the solver corrects it.
  static void fly(cpBody* body, cpVect, cpFloat, cpFloat) {
    cpBodySetVelocity(body, static_cast<const Wanted*>(cpBodyGetUserData(body))->velocity);
  }
  static void walk(cpBody* body, cpVect gravity, cpFloat damping, cpFloat time) {
    cpBodyUpdateVelocity(body, gravity, damping, time);
    auto& wanted = *static_cast<Wanted*>(cpBodyGetUserData(body));
    const cpFloat upwards = wanted.jumps ? wanted.velocity.y : cpBodyGetVelocity(body).y;
    wanted.jumps = false;
    cpBodySetVelocity(body, {wanted.velocity.x, upwards});
  }
  // A body with infinite moment does not rotate. Bodies of one group do not collide with each other.
  void addBody(const std::vector<cpVect>& vertices, Point position, Wanted& wanted) {
    cpBody* const body = cpSpaceAddBody(space_.get(), cpBodyNew(1, INFINITY));
    cpBodySetUserData(body, &wanted);
    if (!hasGravity_) cpBodySetVelocityUpdateFunc(body, &fly);
    cpBodySetPosition(body, metres(position));
    bodies_.push_back(body);
    cpShape* const shape = cpPolyShapeNewRaw(body, static_cast<int>(vertices.size()), vertices.data(), 0);
    cpShapeSetFilter(shape, cpShapeFilterNew(1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
    keep(shape);
  }

  bool hasGravity_;
  std::unique_ptr<cpSpace, void (*)(cpSpace*)> space_;
  cpFloat radius_ = 0;
  cpFloat fastest_ = 0;  // metres per step
  std::vector<Wanted> wanted_;
  std::vector<cpShape*> shapes_;
  std::vector<cpBody*> bodies_;
};

}  // namespace

std::unique_ptr<Engine> makeChipmunk(const Scene& scene) { return std::make_unique<ChipmunkEngine>(scene); }

}  // namespace platon::bench
