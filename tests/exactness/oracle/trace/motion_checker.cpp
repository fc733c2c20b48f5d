#include "tests/exactness/oracle/trace/motion_checker.h"

#include <cmath>

namespace platon::oracle {
namespace {

/// I6: how far an instance's displacement may be from home's, in subunits, and what computing in reals may add.
constexpr long double kStepTolerance = 4 + 1e-6L;
/// An instance that appears or vanishes during a leg does not show one end of its path; that end is known this well.
constexpr std::int64_t kUnseenEnd = 3;

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
  const TurnedShape& shape = shapes_.of(shaped);
  const Box box = shape.box.moved(from.position).joined(shape.box.moved(from.position + displacement));
  for (const MapLine& line : map_.face(from.face).lines) {
    if (!box.touches(line.box)) continue;
    const OpenArea area = OpenArea::swept(shape.polygon, from.position, displacement);
    if (!(tolerance == 0 ? area : area.inset(tolerance)).meets(line.segment)) continue;
    report_.violate("I1 path", name(from) + " going from " + toText(from.position) + " by " + toText(displacement) +
                                   " meets the line " + oracle::toText(line.segment));
    return;
  }
}

void MotionChecker::checkTurn(const TraceInstance& before, const TraceInstance& after) {
  std::vector<Vec> corners;
  for (const TraceInstance* instance : {&before, &after})
    for (const Vec corner : shapes_.of(*instance).polygon) corners.push_back(corner);
  const Polygon hull = convexHull(std::move(corners));
  const OpenArea area = OpenArea::standing(hull, before.position);
  const Box box = boxOf(hull).moved(before.position);
  for (const MapLine& line : map_.face(before.face).lines)
    if (box.touches(line.box) && area.meets(line.segment)) {
      report_.violate("I1 turn", name(before) + " at " + toText(before.position) + " turning from " +
                                     std::to_string(before.angle) + " to " + std::to_string(after.angle) +
                                     " meets the line " + oracle::toText(line.segment));
      return;
    }
}

void MotionChecker::checkStays(const TraceInstance& before, const TraceInstance& after) {
  if (before.position != after.position || before.angle != after.angle)
    report_.violate("home",
                    name(after) + " moves by " + toText(after.position - before.position) + " where home passes");
}

void MotionChecker::checkHomePassing(const TraceLeg& before, const TraceLeg& after) {
  if (findInstance(before, homeOf(after)->id) == nullptr)
    report_.violate("home", name(*homeOf(after)) + " is home from nowhere");
  if (homeOf(before)->face != homeOf(after)->face) ++report_.crossings;
}

void MotionChecker::checkTogether(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                                  const HomeMove& home) {
  if (withoutTurns(after.angle - before.angle) != withoutTurns(home.turn))
    report_.violate("I6", name(after) + " does not turn as home does");
  const RealVec expected = states_.motionFromHome(leg, after).turned(toReal(home.step));
  const Vec step = after.position - before.position;
  const long double error = distance(expected, toReal(step));
  if (error > kStepTolerance)
    report_.violate("I6", name(after) + " moves by " + toText(step) + ", off by " + std::to_string(error));
}

void MotionChecker::checkOld(const TraceLeg& leg, const TraceInstance& before, const TraceInstance& after,
                             const HomeMove& home) {
  if (before.face != after.face) {
    report_.violate("ids", name(after) + " was in face " + std::to_string(before.face));
    return;
  }
  if (home.passes) checkStays(before, after);
  if (before.angle != after.angle) checkTurn(before, after);
  checkTogether(leg, before, after, home);
  checkPath(before, after, after.position - before.position, 0);
}

void MotionChecker::checkNew(const TraceLeg& leg, const TraceInstance& instance, const HomeMove& home) {
  const Vec step = stepOf(leg, instance, home.step);
  TraceInstance start = instance;
  start.position = instance.position - step;
  checkPath(start, instance, step, kUnseenEnd);
  states_.checkFree(instance);
}

MotionChecker::HomeMove MotionChecker::moveOfHome(const TraceLeg& before, const TraceLeg& after) {
  const TraceInstance& home = *homeOf(after);
  const TraceInstance* const earlier = findInstance(before, home.id);
  if (earlier == nullptr) return {true, {}, 0};
  return {homeOf(before)->id != home.id, home.position - earlier->position, home.angle - earlier->angle};
}

void MotionChecker::check(const TraceLeg& before, const TraceLeg& after) {
  const HomeMove home = moveOfHome(before, after);
  if (home.passes) checkHomePassing(before, after);
  for (const TraceInstance& instance : after) {
    const TraceInstance* const earlier = findInstance(before, instance.id);
    if (earlier == nullptr)
      checkNew(after, instance, home);
    else
      checkOld(after, *earlier, instance, home);
  }
  for (const TraceInstance& gone : before)
    if (home.step != Vec{} && findInstance(after, gone.id) == nullptr)
      checkPath(gone, gone, stepOf(before, gone, home.step), kUnseenEnd);
}

}  // namespace platon::oracle
