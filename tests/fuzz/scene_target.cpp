#include <cmath>
#include <stdexcept>

#include "platon/physics/entity.h"
#include "platon/physics/map_part.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/fuzz/checked_rules.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

using oracle::Vec;
using step_check::toPoint;
using step_check::toSegment;
using step_check::toVec;

constexpr std::size_t kMaxEntities = 3;
constexpr std::size_t kMaxSceneTicks = 16;
constexpr std::int32_t kMaxTurn = 1200;
// Largest rounding error of a leg, subunits.
constexpr long double kLegError = 8;

long double lengthOf(Point v) { return std::hypot(static_cast<long double>(v.x), static_cast<long double>(v.y)); }

// Velocity and rotation of an entity in one tick.
struct Order {
  Point velocity;
  std::int32_t turn = 0;
};

step_check::CheckedScene checkedScene(const FuzzScene& scene, const CheckedRules& rules) {
  return {scene.stage.geometry(), scene.shape, scene.solid, scene.faceSize,
          [&rules](std::uint32_t part, std::uint32_t line) { return rules.pierces(part, line); }};
}

class Run {
 public:
  Run(ByteSource& bytes, const FuzzScene& scene)
      : bytes_(bytes),
        scene_(scene),
        turning_(scene.turns && bytes.flag()),
        rules_(scene, bytes.below(4)),
        checker_(checkedScene(scene, rules_)),
        world_(scene.stage),
        twin_(scene.stage) {
    world_.setRules(rules_);
    twin_.addShape(scene.shape);
  }

  std::string run() {
    for (std::size_t i = bytes_.below(kMaxEntities);; --i) {
      if (std::string fault = addEntity(); !fault.empty()) return fault;
      if (i == 0) break;
    }
    for (std::size_t tick = 0; tick < kMaxSceneTicks && !bytes_.empty(); ++tick) {
      if (std::string fault = advance(); !fault.empty()) return "tick " + std::to_string(tick) + ": " + fault;
    }
    return {};
  }

 private:
  std::uint32_t entities() const { return static_cast<std::uint32_t>(world_.entities().size()); }

  std::string addEntity() {
    const auto part = static_cast<std::uint32_t>(bytes_.below(scene_.lines.size()));
    const Point place = startIn(part);
    const Angle angle = scene_.turns ? Angle(static_cast<std::int32_t>(bytes_.between(0, Angle::kTurn - 1))) : Angle();
    const bool free = checker_.isFree(part, place, angle);
    Entity entity(world_, scene_.shape);
    try {
      MapPart(world_, part).insert(entity, place, angle);
    } catch (const std::invalid_argument&) {
      return free && !scene_.solid ? "a free position is refused" : std::string();
    }
    return free ? std::string() : "an entity is inserted where it overlaps a segment";
  }

  // A random place; on a solid, inside the face.
  Point startIn(std::uint32_t part) {
    Vec place = bytes_.vector(scene_.solid ? std::int64_t{scene_.faceSize} * kSubunitsPerUnit : 4 * scene_.scale);
    for (const Warp& warp : scene_.stage.geometry().parts[part]->warps) {
      const auto edge = toSegment(warp.from);
      while (oracle::cross(edge.b - edge.a, place - edge.a) < 0) place = {place.x / 2, place.y / 2};
    }
    return toPoint(place);
  }

  Point anyVelocity(const Entity& entity) {
    const MapGeometry& part = *scene_.stage.geometry().find(entity.part());
    const Segment& line = part.segments.empty() ? Segment{} : part.segments[bytes_.below(part.segments.size())];
    const std::vector<Point>& corners = scene_.shape.vertices();
    const Vec corner = toVec(corners[bytes_.below(corners.size())]);
    switch (bytes_.below(7)) {
      case 0:
        return {};
      case 1:
        return toPoint(bytes_.vector(scene_.scale / 8 + 1));
      case 2:
        return toPoint(bytes_.vector(scene_.scale));
      case 3:
        return toPoint(bytes_.vector(std::min<std::int64_t>(16 * scene_.scale, kVelocityLimit - 1)));
      case 4:
        return toPoint(toVec(line.b) - corner - toVec(entity.position()) + bytes_.vector(1));
      case 5:
        return toPoint(toVec(line.b - line.a) + bytes_.vector(1));
      default:
        return entity.velocity();
    }
  }

  Order orderFor(const Entity& entity) {
    Order order{anyVelocity(entity), 0};
    if (!isVelocity(order.velocity)) order.velocity = {};
    if (turning_ && bytes_.flag()) order.turn = static_cast<std::int32_t>(bytes_.between(-kMaxTurn, kMaxTurn));
    return order;
  }

  std::string advance() {
    if (bytes_.below(4) == 1 && !restoreTwin()) return "a saved state is not accepted";
    std::vector<Order> orders;
    for (std::uint32_t i = 0; i < entities(); ++i) {
      orders.push_back(orderFor(Entity(world_, i)));
      apply(world_, i, orders.back());
      if (hasTwin_) apply(twin_, i, orders.back());
    }
    const WorldState before = world_.save();
    world_.solve(&checker_);
    std::string fault = checker_.finishTick();
    if (fault.empty()) fault = rules_.finishTick();
    if (fault.empty()) fault = moveFault(before, orders);
    return fault.empty() ? twinFault() : fault;
  }

  static void apply(World& world, std::uint32_t index, const Order& order) {
    Entity entity(world, index);
    entity.setVelocity(order.velocity);
    entity.rotate(order.turn);
  }

  // Restores the twin world from the saved state. From then on both must move in the same way.
  bool restoreTwin() {
    if (!twin_.accepts(world_.save())) return false;
    twin_.restore(world_.save());
    hasTwin_ = true;
    return true;
  }

  std::string twinFault() {
    if (!hasTwin_) return {};
    CheckedRules rules = rules_;
    twin_.setRules(rules);
    twin_.solve();
    if (twin_ != world_) return "a restored world moves differently";
    return twin_.hash() == world_.hash() ? std::string() : "equal worlds have different hashes";
  }

  std::string moveFault(const WorldState& before, const std::vector<Order>& orders) const {
    for (std::uint32_t i = 0; i < entities(); ++i) {
      const EntityState& was = before.entities[i];
      const EntityState& is = world_.entities()[i];
      const bool still = orders[i].velocity == Point() && orders[i].turn == 0;
      if (still && (is.position != was.position || is.part != was.part || is.angle != was.angle)) {
        return "an entity without velocity or rotation moves";
      }
      const long double limit = lengthOf(orders[i].velocity) + kLegError * static_cast<long double>(checker_.moves(i));
      if (!scene_.solid && lengthOf(is.position - was.position) > limit) return "an entity moves too far";
    }
    return {};
  }

  ByteSource& bytes_;
  const FuzzScene& scene_;
  bool turning_;
  CheckedRules rules_;
  step_check::StepChecker checker_;
  World world_;
  World twin_;
  bool hasTwin_ = false;
};

}  // namespace

std::string sceneFault(Bytes input) {
  ByteSource bytes(input);
  const auto scene = makeFuzzScene(bytes);
  return scene ? Run(bytes, *scene).run() : std::string();
}

}  // namespace platon::fuzz
