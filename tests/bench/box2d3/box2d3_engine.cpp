// Box2D 3, set up as its manual recommends: metres, bodies that do not rotate, two-sided segments, four substeps and
// one thread. Against what does not move, its collision detection is continuous for every body. In a scene with
// gravity, bodies may sleep; elsewhere their velocities are set before every step, so they could not.
#include <box2d/box2d.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/engines/engine.h"

namespace platon::bench {
namespace {

constexpr int kSubsteps = 4;  // recommended by the manual

float metres(double subunits) { return static_cast<float>(subunits / kSubunitsPerMetre); }

b2Vec2 metres(Point point) { return {metres(point.x), metres(point.y)}; }

// Members that versions 3.0 to 3.2 name differently.
template <class BodyDef>
void forbidRotation(BodyDef& body) {
  if constexpr (requires { body.motionLocks; }) {
    body.motionLocks.angularZ = true;
  } else {
    body.fixedRotation = true;
  }
}

template <class ShapeDef>
void forbidFriction(ShapeDef& shape) {
  if constexpr (requires { shape.material; }) {
    shape.material.friction = 0;
  } else {
    shape.friction = 0;
  }
}

class Box2d3Engine : public Engine {
 public:
  explicit Box2d3Engine(const Scene& scene) : hasGravity_(scene.gravity > 0) {
    b2WorldDef world = b2DefaultWorldDef();
    world.gravity = {0, -metres(scene.gravity * kStepsPerSecond * kStepsPerSecond)};
    world.enableSleep = hasGravity_;
    world.workerCount = 1;
    world_ = b2CreateWorld(&world);
    addSegments(scene.segments);
    std::vector<b2Vec2> vertices;
    for (const Point vertex : scene.shape.vertices()) vertices.push_back(metres(vertex));
    const b2Hull hull = b2ComputeHull(vertices.data(), static_cast<int>(vertices.size()));
    const b2Polygon shape = b2MakePolygon(&hull, 0);
    for (const Point body : scene.bodies) addBody(shape, body);
  }
  ~Box2d3Engine() override { b2DestroyWorld(world_); }
  Box2d3Engine(const Box2d3Engine&) = delete;
  Box2d3Engine& operator=(const Box2d3Engine&) = delete;

  void setVelocity(std::size_t body, Place velocity) override {
    b2Vec2 next = {metres(velocity.x * kStepsPerSecond), metres(velocity.y * kStepsPerSecond)};
    if (hasGravity_ && velocity.y == 0) next.y = b2Body_GetLinearVelocity(bodies_[body]).y;
    b2Body_SetLinearVelocity(bodies_[body], next);
  }
  void step() override { b2World_Step(world_, static_cast<float>(1 / kStepsPerSecond), kSubsteps); }
  Place position(std::size_t body) const override {
    const auto position = b2Body_GetPosition(bodies_[body]);
    return {position.x * kSubunitsPerMetre, position.y * kSubunitsPerMetre};
  }

 private:
  void addSegments(const std::vector<Segment>& lines) {
    const b2BodyDef still = b2DefaultBodyDef();
    const b2BodyId ground = b2CreateBody(world_, &still);
    b2ShapeDef shape = b2DefaultShapeDef();
    forbidFriction(shape);
    for (const Segment& line : lines) {
      const b2Segment segment = {metres(line.a), metres(line.b)};
      b2CreateSegmentShape(ground, &shape, &segment);
    }
  }
  // Bodies do not collide with each other.
  void addBody(const b2Polygon& polygon, Point position) {
    b2BodyDef body = b2DefaultBodyDef();
    body.type = b2_dynamicBody;
    forbidRotation(body);
    body.enableSleep = hasGravity_;
    body.position = {metres(position.x), metres(position.y)};
    bodies_.push_back(b2CreateBody(world_, &body));
    b2ShapeDef shape = b2DefaultShapeDef();
    forbidFriction(shape);
    shape.density = 1;
    shape.filter.groupIndex = -1;
    b2CreatePolygonShape(bodies_.back(), &shape, &polygon);
  }

  bool hasGravity_;
  b2WorldId world_;
  std::vector<b2BodyId> bodies_;
};

std::unique_ptr<Engine> make(const Scene& scene) { return std::make_unique<Box2d3Engine>(scene); }

std::string name() {
  const b2Version version = b2GetVersion();
  return "box2d-" + std::to_string(version.major) + "." + std::to_string(version.minor);
}

}  // namespace

/// What platon-bench looks for in a module.
extern "C" [[gnu::visibility("default")]] const EngineKind platonBenchEngine = {name(), &make};

}  // namespace platon::bench
