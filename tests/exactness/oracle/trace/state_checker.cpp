#include "tests/exactness/oracle/trace/state_checker.h"

#include <algorithm>

namespace platon::oracle {
namespace {

/// Bound of the rounding error of a distance computed in long double, in subunits.
constexpr long double kRealError = 1e-6L;
/// I5: largest distance, in subunits, of an instance from its image under the true isometry.
constexpr long double kPlacementTolerance = 4 + kRealError;
/// Instances of equal angle within this distance, in subunits, are the same placement.
constexpr long double kSamePlacement = 8;
/// I7: largest distance, in subunits, of the centre outside its home face.
constexpr long double kCentreTolerance = 4 + kRealError;
/// An instance whose parent is farther than this, in subunits, from the edge must be dropped.
constexpr std::int64_t kStale = 64;

std::string placedName(const TraceInstance& instance) {
  return "instance " + std::to_string(instance.id) + " in face " + std::to_string(instance.face) + " at " +
         std::to_string(instance.position.x) + " " + std::to_string(instance.position.y);
}

bool isSamePlace(const TraceInstance& instance, std::int64_t face, std::int64_t angle, RealVec position) {
  return instance.face == face && normalizedAngle(instance.angle) == normalizedAngle(angle) &&
         distance(toReal(instance.position), position) <= kSamePlacement;
}

}  // namespace

const TraceInstance* homeOf(const TraceLeg& leg) {
  const auto home = std::find_if(leg.begin(), leg.end(), [](const TraceInstance& instance) { return instance.home; });
  return home == leg.end() ? nullptr : &*home;
}

const TraceInstance* findInstance(const TraceLeg& leg, std::int64_t id) {
  const auto found = std::find_if(leg.begin(), leg.end(), [&](const TraceInstance& i) { return i.id == id; });
  return found == leg.end() ? nullptr : &*found;
}

bool StateChecker::isWellFormed(const TraceLeg& leg, const TraceInstance& instance) {
  const auto isIndex = [](std::int64_t index, std::size_t count) {
    return index >= 0 && index < static_cast<std::int64_t>(count);
  };
  if (!isIndex(instance.face, map_.faces().size()) || findInstance(leg, instance.id) != &instance) return false;
  if (instance.home) return true;
  const TraceInstance* parent = findInstance(leg, instance.parent);
  if (parent == nullptr || parent == &instance || !isIndex(parent->face, map_.faces().size())) return false;
  const MapFace& face = map_.face(parent->face);
  return isIndex(instance.warp, face.warps.size()) &&
         face.warps[static_cast<std::size_t>(instance.warp)].to == static_cast<std::size_t>(instance.face);
}

bool StateChecker::isConnectedToHome(const TraceLeg& leg, const TraceInstance& instance) const {
  const TraceInstance* at = &instance;
  for (std::size_t i = 0; i < leg.size() && !at->home; ++i) at = findInstance(leg, at->parent);
  return at->home;
}

bool StateChecker::isTree(const TraceLeg& leg) {
  report_.noteInstances(leg.size());
  const auto homes = std::count_if(leg.begin(), leg.end(), [](const TraceInstance& i) { return i.home; });
  if (homes != 1) {
    report_.violate("tree", std::to_string(homes) + " home instances");
    return false;
  }
  for (const TraceInstance& instance : leg)
    if (!isWellFormed(leg, instance)) {
      report_.violate("tree", placedName(instance) + " has a wrong id, face or via");
      return false;
    }
  for (const TraceInstance& instance : leg)
    if (!isConnectedToHome(leg, instance)) {
      report_.violate("tree", placedName(instance) + " is not connected to the home instance");
      return false;
    }
  return true;
}

const MapWarp& StateChecker::warpOf(const TraceLeg& leg, const TraceInstance& instance) const {
  return map_.face(findInstance(leg, instance.parent)->face).warps[static_cast<std::size_t>(instance.warp)];
}

RealVec StateChecker::positionFromHome(const TraceLeg& leg, const TraceInstance& instance) const {
  if (instance.home) return toReal(instance.position);
  return warpOf(leg, instance).motion.apply(positionFromHome(leg, *findInstance(leg, instance.parent)));
}

Isometry StateChecker::motionFromHome(const TraceLeg& leg, const TraceInstance& instance) const {
  std::int64_t turn = 0;
  for (const TraceInstance* at = &instance; !at->home; at = findInstance(leg, at->parent))
    turn += warpOf(leg, *at).motion.turn();
  return Isometry(turn, toReal(homeOf(leg)->position), positionFromHome(leg, instance));
}

void StateChecker::checkPlacement(const TraceLeg& leg, const TraceInstance& instance) {
  if (instance.home) return;
  const TraceInstance& parent = *findInstance(leg, instance.parent);
  const Isometry& motion = warpOf(leg, instance).motion;
  if (normalizedAngle(parent.angle + motion.turn()) != normalizedAngle(instance.angle))
    report_.violate("I5 angle", placedName(instance) + ": angle " + std::to_string(instance.angle) + ", its parent's " +
                                    std::to_string(parent.angle) + ", turn of the warp " +
                                    std::to_string(motion.turn()));
  const RealVec place = toReal(instance.position);
  const long double error = distance(place, positionFromHome(leg, instance));
  report_.notePlacementError(error);
  if (error > kPlacementTolerance)
    report_.violate("I5 home",
                    placedName(instance) + " is off by " + std::to_string(error) + " relative to the home instance");
  const long double link = distance(place, motion.apply(toReal(parent.position)));
  if (link > kPlacementTolerance)
    report_.violate("I5 parent", placedName(instance) + " is off by " + std::to_string(link) + " from its parent");
}

void StateChecker::checkDuplicates(const TraceLeg& leg) {
  for (std::size_t i = 0; i < leg.size(); ++i)
    for (std::size_t j = i + 1; j < leg.size(); ++j)
      if (isSamePlace(leg[i], leg[j].face, leg[j].angle, toReal(leg[j].position)))
        report_.violate("duplicate", placedName(leg[i]) + " and " + placedName(leg[j]) + " are the same placement");
}

void StateChecker::checkPlacements(const TraceLeg& leg) {
  for (const TraceInstance& instance : leg) {
    shapes_.of(instance);
    checkPlacement(leg, instance);
    checkCoverage(leg, instance);
  }
  checkDuplicates(leg);
}

bool StateChecker::isCovered(const TraceLeg& leg, const TraceInstance& instance, std::size_t warp) const {
  const MapWarp& through = map_.face(instance.face).warps[warp];
  if (!instance.home && warpOf(leg, instance).reverse == warp) return true;
  const RealVec place = through.motion.apply(toReal(instance.position));
  const std::int64_t angle = instance.angle + through.motion.turn();
  return std::any_of(leg.begin(), leg.end(), [&](const TraceInstance& other) {
    const bool isChild = !other.home && other.parent == instance.id && other.warp == static_cast<std::int64_t>(warp);
    return isChild || isSamePlace(other, static_cast<std::int64_t>(through.to), angle, place);
  });
}

bool StateChecker::reachesThrough(const TraceInstance& instance, const MapWarp& warp) {
  const RotatedShape& shape = shapes_.of(instance);
  if (!shape.box.moved(instance.position).touches(warp.box)) return false;
  const OpenArea area = OpenArea::placed(shape.polygon, instance.position);
  return area.intersects(warp.from) && area.intersects(warp.beyond);
}

void StateChecker::checkCoverage(const TraceLeg& leg, const TraceInstance& instance) {
  const std::vector<MapWarp>& warps = map_.face(instance.face).warps;
  for (std::size_t warp = 0; warp < warps.size(); ++warp)
    if (reachesThrough(instance, warps[warp]) && !isCovered(leg, instance, warp))
      report_.violate("coverage", placedName(instance) + " reaches through warp " + std::to_string(warp) +
                                      " into face " + std::to_string(warps[warp].to) + ", where it has no instance");
}

void StateChecker::checkFree(const TraceInstance& instance, bool arrived) {
  const RotatedShape& shape = shapes_.of(instance);
  const Box box = shape.box.moved(instance.position);
  for (const MapLine& line : map_.face(instance.face).lines)
    if (box.touches(line.box) && (arrived ? blocking_.forbids(line, instance) : blocking_.blocksAlways(line)) &&
        OpenArea::placed(shape.polygon, instance.position).intersects(line.segment)) {
      report_.violate("I1 place", placedName(instance) + " overlaps the segment " + toText(line.segment));
      return;
    }
}

bool StateChecker::isStale(const TraceLeg& leg, const TraceInstance& instance) {
  const TraceInstance& parent = *findInstance(leg, instance.parent);
  const OpenArea area = OpenArea::placed(shapes_.of(parent).polygon, parent.position);
  return !area.inset(-kStale).intersects(warpOf(leg, instance).from);
}

void StateChecker::checkTickEnd(const TraceLeg& leg) {
  const TraceInstance& home = *homeOf(leg);
  for (const MapWarp& warp : map_.face(home.face).warps) {
    const Vec along = warp.from.b - warp.from.a;
    const long double outside = -static_cast<long double>(cross(along, home.position - warp.from.a)) /
                                distance(toReal(warp.from.a), toReal(warp.from.b));
    if (outside > kCentreTolerance)
      report_.violate("I7", placedName(home) + " has its centre " + std::to_string(outside) + " outside");
  }
  for (const TraceInstance& instance : leg)
    if (!instance.home && isStale(leg, instance))
      report_.violate("stale", placedName(instance) + " is behind an edge that the shape no longer reaches");
}

}  // namespace platon::oracle
