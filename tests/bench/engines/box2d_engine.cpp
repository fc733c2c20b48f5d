// Box2D 2.4, set up as its manual recommends: metres, bullets with fixed rotation, two-sided edges. In a scene with
// gravity, bodies may sleep; elsewhere their velocities are set before every step, so they could not.
#include <box2d/box2d.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "tests/bench/engines/engine.h"

namespace platon::bench {
namespace {

constexpr int kVelocityIterations = 8;  // recommended by the manual, like the next
constexpr int kPositionIterations = 3;

float metres(double subunits) { return static_cast<float>(subunits / kSubunitsPerMetre); }

b2Vec2 metres(Point point) { return {metres(point.x), metres(point.y)}; }

class Box2dEngine : public Engine {
 public:
  explicit Box2dEngine(const Scene& scene)
      : hasGravity_(scene.gravity > 0), world_({0, -metres(scene.gravity * kStepsPerSecond * kStepsPerSecond)}) {
    addSegments(scene.segments);
    b2PolygonShape shape;
    std::vector<b2Vec2> vertices;
    for (const Point vertex : scene.shape.vertices()) vertices.push_back(metres(vertex));
    shape.Set(vertices.data(), static_cast<int32>(vertices.size()));
    for (const Point body : scene.bodies) addBody(shape, body);
  }

  void setVelocity(std::size_t body, Place velocity) override {
    b2Vec2 next = {metres(velocity.x * kStepsPerSecond), metres(velocity.y * kStepsPerSecond)};
    if (hasGravity_ && velocity.y == 0) next.y = bodies_[body]->GetLinearVelocity().y;
    bodies_[body]->SetLinearVelocity(next);
  }
  void step() override {
    world_.Step(static_cast<float>(1 / kStepsPerSecond), kVelocityIterations, kPositionIterations);
  }
  Place position(std::size_t body) const override {
    const b2Vec2 position = bodies_[body]->GetPosition();
    return {position.x * kSubunitsPerMetre, position.y * kSubunitsPerMetre};
  }

 private:
  void addSegments(const std::vector<Segment>& lines) {
    const b2BodyDef still;
    b2Body* const ground = world_.CreateBody(&still);
    for (const Segment& line : lines) {
      b2EdgeShape edge;
      edge.SetTwoSided(metres(line.a), metres(line.b));
      b2FixtureDef fixture;
      fixture.shape = &edge;
      fixture.friction = 0;
      ground->CreateFixture(&fixture);
    }
  }
  // Bodies do not collide with each other.
  void addBody(const b2PolygonShape& shape, Point position) {
    b2BodyDef body;
    body.type = b2_dynamicBody;
    body.bullet = true;
    body.fixedRotation = true;
    body.allowSleep = hasGravity_;
    body.position = metres(position);
    bodies_.push_back(world_.CreateBody(&body));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.filter.groupIndex = -1;
    bodies_.back()->CreateFixture(&fixture);
  }

  bool hasGravity_;
  b2World world_;
  std::vector<b2Body*> bodies_;
};

}  // namespace

std::unique_ptr<Engine> makeBox2d(const Scene& scene) { return std::make_unique<Box2dEngine>(scene); }

}  // namespace platon::bench
