#include "tests/exactness/step_check/step_checker.h"

#include "tests/exactness/oracle/trace/move_count.h"
#include "tests/exactness/step_check/conversions.h"

namespace platon::step_check {
namespace {

std::vector<oracle::Segment> blockingSegments(const CheckedScene& scene, const MapGeometry& part) {
  std::vector<oracle::Segment> lines;
  for (std::uint32_t i = 0; i < part.segmentOfWarp(0); ++i) {
    if (!scene.pierces || !scene.pierces(part.id, i)) lines.push_back(toSegment(part.segments[i]));
  }
  return lines;
}

oracle::TraceHeader headerOf(const CheckedScene& scene) {
  oracle::TraceHeader header;
  header.solid = scene.solid ? nameOf(*scene.solid) : "PLANE";
  header.shape = toPolygon(scene.shape.vertices());
  for (const auto& part : scene.geometry.parts) {
    oracle::TraceFace face;
    if (scene.solid) face.polygon = toPolygon(facePolygon(*scene.solid, scene.faceSize));
    face.lines = blockingSegments(scene, *part);
    for (const Warp& warp : part->warps) {
      face.warps.push_back({toSegment(warp.from), warp.target, toSegment(warp.onto)});
    }
    header.faces.push_back(std::move(face));
  }
  for (const Element& element : scene.elements) {
    const auto numberOf = [&](std::size_t index, std::uint16_t number) -> std::int64_t {
      return index < numbersOf(element.kind) ? number : -1;
    };
    header.elements.push_back({element.face, element.segment, std::string(wordOf(element.kind)),
                               numberOf(0, element.number), numberOf(1, element.openTicks)});
  }
  return header;
}

}  // namespace

struct StepChecker::Checkers {
  Checkers(oracle::TraceMap checkedMap, oracle::TraceReport& report)
      : map(std::move(checkedMap)),
        shapes(map.shape(), report),
        blocking(map, shapes, report),
        states(map, shapes, blocking, report),
        motions(map, shapes, blocking, states, report) {}

  oracle::TraceMap map;
  oracle::ShapeLibrary shapes;
  oracle::Blocking blocking;
  oracle::StateChecker states;
  oracle::MotionChecker motions;
};

StepChecker::StepChecker(const CheckedScene& scene) : shape_(scene.shape), elements_(scene.elements) {
  auto map = oracle::TraceMap::make(headerOf(scene), report_);
  if (map) checkers_ = std::make_shared<Checkers>(std::move(*map), report_);
}

void StepChecker::leg(std::uint32_t entity, std::span<const InstanceView> instances) {
  oracle::TraceLeg& leg = legs_[entity].emplace_back();
  for (const InstanceView& view : instances) leg.push_back(converted(view));
}

oracle::TraceInstance StepChecker::converted(const InstanceView& view) const {
  oracle::TraceInstance instance{
      view.id, view.part, toVec(view.position), view.angle.centidegrees(), !view.hasParent, view.parent, view.warp, {}};
  const auto turned = shape_.turned(view.angle);
  if (turned && !(*turned == shape_)) instance.shape = toPolygon(turned->vertices());
  return instance;
}

std::string StepChecker::finishTick(OpenElements open) {
  tallies_.clear();
  std::vector<std::int64_t> opened;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    if (open.has(elements_[i])) opened.push_back(static_cast<std::int64_t>(i));
  }
  if (checkers_) checkers_->blocking.setOpen(opened, open.tick);
  for (const auto& [entity, legs] : legs_) {
    report_.setPlayer(entity);
    tallies_[entity] = {legs.size() - 1, legs.back().size()};
    if (checkers_) checkStep(legs);
  }
  legs_.clear();
  return report_.clean() ? std::string() : report_.messages().front();
}

std::size_t StepChecker::moves(std::uint32_t entity) const {
  const auto found = tallies_.find(entity);
  return found == tallies_.end() ? 0 : found->second.moves;
}

std::size_t StepChecker::instances(std::uint32_t entity) const {
  const auto found = tallies_.find(entity);
  return found == tallies_.end() ? 0 : found->second.instances;
}

bool StepChecker::isFree(std::uint32_t part, Point position, Angle angle) {
  if (!checkers_) return true;
  const auto shape = shape_.turned(angle);
  if (!shape) return true;
  const auto area = oracle::OpenArea::placed(toPolygon(shape->vertices()), toVec(position));
  for (const oracle::MapLine& line : checkers_->map.face(part).lines) {
    if (area.intersects(line.segment)) return false;
  }
  return true;
}

void StepChecker::checkStep(const std::vector<oracle::TraceLeg>& legs) {
  oracle::StateChecker& states = checkers_->states;
  if (const std::size_t moves = oracle::movesOf(legs); moves > oracle::kMaxMoves) {
    report_.violate("I2", std::to_string(moves) + " moves");
  }
  if (!states.isTree(legs.front())) return;
  states.checkPlacements(legs.front());
  for (const oracle::TraceInstance& instance : legs.front()) states.checkFree(instance, false);
  for (std::size_t i = 1; i < legs.size(); ++i) {
    report_.setLeg(i);
    if (!states.isTree(legs[i])) return;
    states.checkPlacements(legs[i]);
    checkers_->motions.check(legs[i - 1], legs[i]);
  }
  states.checkTickEnd(legs.back());
}

}  // namespace platon::step_check
