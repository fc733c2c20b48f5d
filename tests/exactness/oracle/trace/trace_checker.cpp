#include "tests/exactness/oracle/trace/trace_checker.h"

#include <algorithm>
#include <cstdlib>

#include "tests/exactness/oracle/trace/json_reader.h"
#include "tests/exactness/oracle/trace/move_count.h"
#include "tests/exactness/oracle/trace/trace_reader.h"

namespace platon::oracle {
namespace {

/// I2: largest number of entries that a trace lists for a step: one for its start, 64 for moves; for each of 64 legs
/// one for insertions, one for removals and two for each of four rehomes; and one for removals at its end.
constexpr std::size_t kMaxEntries = 706;
static_assert(kMaxEntries == 1 + 64 + 64 * (1 + 1 + 2 * 4) + 1);

bool isSameState(TraceLeg a, TraceLeg b) {
  const auto byId = [](const TraceInstance& x, const TraceInstance& y) { return x.id < y.id; };
  if (a == b) return true;
  std::sort(a.begin(), a.end(), byId);
  std::sort(b.begin(), b.end(), byId);
  return a == b;
}

}  // namespace

bool TraceChecker::checkLine(std::string_view line) {
  try {
    return checkers_ == nullptr ? checkHeader(line) : checkTick(line);
  } catch (const JsonError& error) {
    report_.violate("format", error.what());
    return false;
  }
}

void TraceChecker::finish() {
  if (checkers_ == nullptr && report_.clean()) report_.violate("format", "no header");
}

bool TraceChecker::checkHeader(std::string_view line) {
  std::optional<TraceMap> map = TraceMap::make(readTraceHeader(line), report_);
  if (!map) return false;
  checkers_ = std::make_unique<Checkers>(std::move(*map), report_);
  return true;
}

bool TraceChecker::checkTick(std::string_view line) {
  const TraceTick tick = readTraceTick(line);
  report_.setTick(tick.tick);
  report_.setPlayer(-1);
  if (lastTick_ && tick.tick != *lastTick_ + 1)
    report_.violate("format", "does not follow tick " + std::to_string(*lastTick_));
  lastTick_ = tick.tick;
  ++report_.ticks;
  checkers_->blocking.setOpen(tick.open, tick.tick - 1);
  std::map<std::int64_t, TraceLeg> now;
  for (const TracePlayer& player : tick.players) checkPlayer(player, now);
  last_ = std::move(now);
  return true;
}

// A player that restarts, or has touched a hazard, returns with a new home instance to the place where all players
// begin or to the middle of a checkpoint.
bool TraceChecker::isReturn(const TraceLeg& earlier, const TraceLeg& start) const {
  const TraceInstance& home = *homeOf(start);
  if (findInstance(earlier, home.id) != nullptr) return false;
  if (home.face == first_->face && home.position == first_->position && home.angle == first_->angle) return true;
  const std::vector<MapElement>& elements = checkers_->map.elements();
  return std::any_of(elements.begin(), elements.end(), [&](const MapElement& element) {
    const Vec offMiddle = home.position + home.position - element.segment.a - element.segment.b;
    return element.word == Word::kCheckpoint && element.face == home.face && std::abs(offMiddle.x) <= 1 &&
           std::abs(offMiddle.y) <= 1;
  });
}

bool TraceChecker::checkStart(const TracePlayer& player) {
  const TraceLeg& start = player.legs.front();
  const auto earlier = last_.find(player.id);
  if (earlier != last_.end() && earlier->second == start) return true;
  if (!checkers_->states.isTree(start)) return false;
  if (!first_) first_ = *homeOf(start);
  const bool continues = earlier != last_.end() && isSameState(earlier->second, start);
  if (earlier != last_.end() && !continues) {
    if (!isReturn(earlier->second, start)) report_.violate("continuity", "does not start where the last tick ended");
    ++report_.returns;
  }
  checkers_->states.checkPlacements(start);
  for (const TraceInstance& instance : start) checkers_->states.checkFree(instance, !continues);
  return true;
}

bool TraceChecker::checkLeg(const TraceLeg& before, const TraceLeg& after) {
  if (before == after) return true;
  if (!checkers_->states.isTree(after)) return false;
  checkers_->states.checkPlacements(after);
  checkers_->motions.check(before, after);
  return true;
}

void TraceChecker::checkPlayer(const TracePlayer& player, std::map<std::int64_t, TraceLeg>& now) {
  report_.setPlayer(player.id);
  report_.setLeg(0);
  ++report_.playerTicks;
  if (player.legs.empty() || now.contains(player.id)) {
    report_.violate("format", player.legs.empty() ? "player without legs" : "player occurs twice");
    return;
  }
  if (!checkStart(player)) return;
  for (std::size_t leg = 1; leg < player.legs.size(); ++leg) {
    report_.setLeg(leg);
    if (!checkLeg(player.legs[leg - 1], player.legs[leg])) return;
  }
  report_.noteLegs(player.legs.size() - 1);
  if (const std::size_t moves = movesOf(player.legs); moves > kMaxMoves) {
    report_.violate("I2", std::to_string(moves) + " moves");
  }
  if (player.legs.size() > kMaxEntries) report_.violate("I2", std::to_string(player.legs.size()) + " entries");
  checkers_->states.checkTickEnd(player.legs.back());
  report_.facesVisited.insert(homeOf(player.legs.back())->face);
  now[player.id] = player.legs.back();
}

}  // namespace platon::oracle
