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

constexpr cpFloat kSlop = 0.005;  // metres; Chipmunk lets shapes overlap by the slop

cpFloat metres(double subunits) { return subunits / kSubunitsPerMetre; }

cpVect metres(Point point) { return {metres(point.x), metres(point.y)}; }

class ChipmunkEngine : public Engine {
 public:
  explicit ChipmunkEngine(const Scene& scene) : space_(cpSpaceNew(), &cpSpaceFree) {
    const Box& bounds = scene.shape.bounds();
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
    wanted_[body] = {metres(velocity.x * kStepsPerSecond), metres(velocity.y * kStepsPerSecond)};
    fastest_ = std::max(fastest_, cpvlength(wanted_[body]) / kStepsPerSecond);
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
  // A body with infinite moment does not rotate. Bodies of one group do not collide with each other. Chipmunk moves
  // bodies before it detects collisions. The callback sets the velocity between these two stages, so that the solver
  // corrects it.
  void addBody(const std::vector<cpVect>& vertices, Point position, cpVect& wanted) {
    cpBody* const body = cpSpaceAddBody(space_.get(), cpBodyNew(1, INFINITY));
    cpBodySetUserData(body, &wanted);
    cpBodySetVelocityUpdateFunc(body, [](cpBody* moved, cpVect, cpFloat, cpFloat) {
      cpBodySetVelocity(moved, *static_cast<const cpVect*>(cpBodyGetUserData(moved)));
    });
    cpBodySetPosition(body, metres(position));
    bodies_.push_back(body);
    cpShape* const shape = cpPolyShapeNewRaw(body, static_cast<int>(vertices.size()), vertices.data(), 0);
    cpShapeSetFilter(shape, cpShapeFilterNew(1, CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
    keep(shape);
  }

  std::unique_ptr<cpSpace, void (*)(cpSpace*)> space_;
  cpFloat radius_ = 0;
  cpFloat fastest_ = 0;         // metres per step
  std::vector<cpVect> wanted_;  // metres per second, by body
  std::vector<cpShape*> shapes_;
  std::vector<cpBody*> bodies_;
};

}  // namespace

std::unique_ptr<Engine> makeChipmunk(const Scene& scene) { return std::make_unique<ChipmunkEngine>(scene); }

}  // namespace platon::bench
