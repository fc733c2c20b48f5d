#include "tests/exactness/oracle/trace/motion_checker.h"

#include <cmath>

namespace platon::oracle {
namespace {

/// I6: largest difference, in subunits, between the displacement of an instance and that of the home instance; plus the
/// rounding of long double.
constexpr long double kStepTolerance = 4 + 1e-6L;
/// Uncertainty, in subunits, of the end of a path that the trace does not show: the start of an instance that appears
/// in a leg, and the end of one that vanishes.
constexpr std::int64_t kUnknownEndTolerance = 3;

std::string name(const TraceInstance& instance) {
  return "instance " + std::to_string(instance.id) + " in face " + std::to_string(instance.face);
}

std::string toText(Vec v) { return std::to_string(v.x) + " " + std::to_string(v.y); }

}  // namespace

Vec MotionChecker::stepOf(const TraceLeg& leg, const TraceInstance& instance, Vec homeStep) const {
  const RealVec step = states_.motionFromHome(leg, instance).turned(toReal(homeStep));
  return {std::llround(step.x), std::llround(step.y)};
}

void MotionChecker::checkPath(const TraceInstance& from, const TraceInstance& shaped, Vec displacement,
                              std::int64_t tolerance) {
  const RotatedShape& shape = shapes_.of(shaped);
  const Box box = shape.box.moved(from.position).joined(shape.box.moved(from.position + displacement));
  for (const MapLine& line : map_.face(from.face).lines) {
    if (!box.touches(line.box)) continue;
    const OpenArea area = OpenArea::swept(shape.polygon, from.position, displacement);
    if (!(tolerance == 0 ? area : area.inset(tolerance)).intersects(line.segment)) continue;
    if (!blocking_.blocks(line, from)) {
      report_.elementsPassed.insert(line.element);
      continue;
    }
    report_.violate("I1 path", name(from) + " moving from " + toText(from.position) + " by " + toText(displacement) +
                                   " intersects the segment " + oracle::toText(line.segment));
    return;
  }
}

void MotionChecker::checkRotation(const TraceInstance& before, const TraceInstance& after) {
  std::vector<Vec> corners;
  for (const TraceInstance* instance : {&before, &after})
    for (const Vec corner : shapes_.of(*instance).polygon) corners.push_back(corner);
  const Polygon hull = convexHull(std::move(corners));
  const OpenArea area = OpenArea::placed(hull, before.position);
  const Box box = boxOf(hull).moved(before.position);
  for (const MapLine& line : map_.face(before.face).lines)
    if (box.touches(line.box) && area.intersects(line.segment) && blocking_.blocks(line, before)) {
      report_.violate("I1 turn", name(before) + " at " + toText(before.position) + " rotating from " +
                                     std::to_string(before.angle) + " to " + std::to_string(after.angle) +
                                     " intersects the segment " + oracle::toText(line.segment));
      return;
    }
}

void MotionChecker::checkUnmoved(const TraceInstance& before, const TraceInstance& after) {
  if (before.position != after.position || before.angle != after.angle)
    report_.violate("home",
                    name(after) + " moves by " + toText(after.position - before.position) + " in a leg that rehomes");
}

void MotionChecker::checkRehome(const TraceLeg& before, const TraceLeg& after) {
  if (findInstance(before, homeOf(after)->id) == nullptr)
    report_.violate("home", name(*homeOf(after)) + " is home but did not exist before");
  if (homeOf(before)->face != homeOf(after)->face) ++report_.crossings;
}

void MotionChecker::checkMovesWithHome(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                                       const HomeMove& home) {
  if (normalizedAngle(after.angle - before.angle) != normalizedAngle(home.turn))
    report_.violate("I6", name(after) + " does not rotate like the home instance");
  const RealVec expected = states_.motionFromHome(leg, after).turned(toReal(home.step));
  const Vec step = after.position - before.position;
  const long double error = distance(expected, toReal(step));
  if (error > kStepTolerance)
    report_.violate("I6", name(after) + " moves by " + toText(step) + ", off by " + std::to_string(error));
}

void MotionChecker::checkKeptInstance(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                                      const HomeMove& home) {
  if (before.face != after.face) {
    report_.violate("ids", name(after) + " was in face " + std::to_string(before.face));
    return;
  }
  if (home.rehomes) checkUnmoved(before, after);
  if (before.angle != after.angle) checkRotation(before, after);
  checkMovesWithHome(leg, before, after, home);
  checkPath(before, after, after.position - before.position, 0);
}

void MotionChecker::checkNewInstance(const TraceLeg& leg, const TraceInstance& instance, const HomeMove& home) {
  const Vec step = stepOf(leg, instance, home.step);
  TraceInstance start = instance;
  start.position = instance.position - step;
  checkPath(start, instance, step, kUnknownEndTolerance);
  states_.checkFree(instance, true);
}

MotionChecker::HomeMove MotionChecker::moveOfHome(const TraceLeg& before, const TraceLeg& after) {
  const TraceInstance& home = *homeOf(after);
  const TraceInstance* const earlier = findInstance(before, home.id);
  if (earlier == nullptr) return {true, {}, 0};
  return {homeOf(before)->id != home.id, home.position - earlier->position, home.angle - earlier->angle};
}

void MotionChecker::check(const TraceLeg& before, const TraceLeg& after) {
  const HomeMove home = moveOfHome(before, after);
  if (home.rehomes) checkRehome(before, after);
  for (const TraceInstance& instance : after) {
    const TraceInstance* const earlier = findInstance(before, instance.id);
    if (earlier == nullptr)
      checkNewInstance(after, instance, home);
    else
      checkKeptInstance(after, *earlier, instance, home);
  }
  for (const TraceInstance& vanished : before)
    if (home.step != Vec{} && findInstance(after, vanished.id) == nullptr)
      checkPath(vanished, vanished, stepOf(before, vanished, home.step), kUnknownEndTolerance);
}

}  // namespace platon::oracle
