#include "client/editor/level_analysis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>

#include "levels/check/level_warnings.h"
#include "levels/drawing/solid_frame.h"
#include "levels/reach/jump_heights.h"
#include "levels/solve/level_solver.h"
#include "platon/game/game.h"

namespace platon {
namespace {

constexpr double kSmallestStep = 16;      // of the lattice of reached places, level units
constexpr double kStepsPerFace = 40;      // at most, along an edge
constexpr std::size_t kPathTicks = 4;     // between two places of a path
constexpr std::uint32_t kPressCost = 30;  // so that the way is an easy one

std::vector<FacePlace> reachedPlaces(const Level& level, const JumpHeights& heights) {
  const SolidFrame frame(level.solid, level.faceSize);
  const double step = std::max(kSmallestStep, level.faceSize / kStepsPerFace);
  const int half = static_cast<int>(std::ceil(glm::length(frame.polygon()[0]) / step));
  std::vector<FacePlace> places;
  for (int face = 0; face < frame.faces(); ++face) {
    for (int row = -half; row <= half; ++row) {
      for (int column = -half; column <= half; ++column) {
        const glm::dvec2 place = glm::dvec2(column, row) * step;
        const bool inside = std::all_of(frame.edgeNormals().begin(), frame.edgeNormals().end(),
                                        [&](glm::dvec2 normal) { return glm::dot(normal, place) <= frame.apothem(); });
        const Point point(static_cast<std::int32_t>(place.x * kSubunitsPerUnit),
                          static_cast<std::int32_t>(place.y * kSubunitsPerUnit));
        if (inside && heights.reaches(static_cast<std::uint32_t>(face), point)) places.push_back({face, place});
      }
    }
  }
  return places;
}

std::vector<std::vector<FacePlace>> pathsOf(const std::shared_ptr<const Level>& level, const Solution& solution) {
  std::vector<std::vector<FacePlace>> paths(level->players);
  Game game(level);
  for (std::size_t tick = 0; tick < solution.size(); ++tick) {
    game.advance(solution[tick]);
    for (std::uint32_t slot = 0; slot < game.slots() && tick % kPathTicks == 0; ++slot) {
      const EntityState& entity = game.world().entities()[slot];
      paths[slot].push_back({static_cast<int>(entity.part), toUnits(entity.position)});
    }
  }
  return paths;
}

}  // namespace

void LevelAnalysis::start(std::shared_ptr<const Level> level) {
  report_ = std::make_shared<Report>();
  analysing_.restart([level = std::move(level), published = report_](const std::stop_token& stop) {
    return analyse(level, *published, [&] { return stop.stop_requested(); });
  });
}

std::optional<LevelReport> LevelAnalysis::take() {
  (void)analysing_.poll();
  const std::lock_guard lock(report_->mutex);
  return std::exchange(report_->newest, std::nullopt);
}

// Returns whether the analysis has ended by itself.
bool LevelAnalysis::analyse(const std::shared_ptr<const Level>& level, Report& published,
                            const std::function<bool()>& stop) {
  LevelReport report;
  report.level = level;
  published.set(report);
  JumpHeights::Options options;
  options.stop = stop;
  const JumpHeights heights(*level, options);
  if (heights.isStopped()) return false;
  report.reached = std::make_shared<const std::vector<FacePlace>>(reachedPlaces(*level, heights));
  if (!heights.reachesGoal()) report.way = LevelReport::Way::kImpossible;
  published.set(report);
  if (heights.reachesGoal()) search(report, stop);
  published.set(report);
  report.warnings = warningsOf(level, stop);
  report.finished = true;
  published.set(report);
  return true;
}

void LevelAnalysis::search(LevelReport& report, const std::function<bool()>& stop) {
  LevelSolver solver(report.level);
  LevelSolver::Limits limits;
  limits.states = kMaxStates;
  limits.pressCost = kPressCost;
  limits.stop = stop;
  const std::optional<Solution> solution = solver.solve(limits);
  if (stop()) return;  // what follows takes some hundredths of a second
  report.states = solver.states();
  const std::optional<SolutionFacts> facts = solution ? factsOf(report.level, *solution) : std::nullopt;
  report.way = facts ? LevelReport::Way::kFound : LevelReport::Way::kNotFound;
  if (facts) report.facts = *facts;
  if (facts) report.paths = pathsOf(report.level, *solution);
}

void LevelAnalysis::Report::set(const LevelReport& report) {
  const std::lock_guard lock(mutex);
  newest = report;
}

}  // namespace platon
