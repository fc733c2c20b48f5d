// Box2D 2.4, set up as its manual recommends: metres, bullets with fixed rotation, two-sided edges, no gravity.
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
  explicit Box2dEngine(const Scene& scene) : world_({0, 0}) {
    addSegments(scene.segments);
    b2PolygonShape shape;
    std::vector<b2Vec2> vertices;
    for (const Point vertex : scene.shape.vertices()) vertices.push_back(metres(vertex));
    shape.Set(vertices.data(), static_cast<int32>(vertices.size()));
    for (const Point body : scene.bodies) addBody(shape, body);
  }

  void setVelocity(std::size_t body, Place velocity) override {
    bodies_[body]->SetLinearVelocity({metres(velocity.x * kStepsPerSecond), metres(velocity.y * kStepsPerSecond)});
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
    body.allowSleep = false;
    body.position = metres(position);
    bodies_.push_back(world_.CreateBody(&body));
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.density = 1;
    fixture.friction = 0;
    fixture.filter.groupIndex = -1;
    bodies_.back()->CreateFixture(&fixture);
  }

  b2World world_;
  std::vector<b2Body*> bodies_;
};

}  // namespace

std::unique_ptr<Engine> makeBox2d(const Scene& scene) { return std::make_unique<Box2dEngine>(scene); }

}  // namespace platon::bench
