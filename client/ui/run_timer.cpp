#include "client/ui/run_timer.h"

#include <cmath>
#include <cstdlib>

#include "client/ui/player_rows.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kFirstRow = 38;   // middle of the clock of the round, or of the own time without one
constexpr float kSecondRow = 78;  // middle of the own time below a clock
constexpr float kDifferenceSize = 20;

// The best time of the round, unless there is a best run, which counts more.
std::string bestTextOf(const Scene& scene, const RunStatus& run) {
  const auto& [seconds, arrived] = *scene.attempt;
  if (arrived && run.isNewBest) return "new personal best";
  if (run.best) return "personal best " + finishText(*run.best);
  const std::optional<double> best = scene.players.back().finishSeconds;
  return best && !(arrived && *best == seconds) ? "best " + finishText(*best) : "";
}

// At the right of a pill that is `half` wide from its middle.
void addDifference(OverlayWriter& writer, double seconds, glm::vec2 middle, float half) {
  const std::string text = differenceText(seconds);
  const float from = middle.x + half + kDifferenceSize + writer.width(text, kDifferenceSize) / 2 + 8;
  writer.pill(text, {from, middle.y}, kDifferenceSize, seconds <= 0 ? kGood : kWarning);
}

// One pill below the clock of the round.
void addBelowClock(OverlayWriter& writer, const Scene& scene, const RunStatus& run, float width) {
  const auto& [seconds, arrived] = *scene.attempt;
  const float size = arrived ? 18 : 14;
  const std::string best = bestTextOf(scene, run);
  const std::string own = (arrived ? "★  Goal in " : "your time ") + finishText(seconds);
  const std::string text = best.empty() ? own : own + "   " + best;
  const glm::vec2 middle(width / 2, kSecondRow);
  writer.pill(text, middle, size, arrived ? kGold : kSoft);
  if (run.difference) addDifference(writer, *run.difference, middle, writer.width(text, size) / 2 + size);
}

// In place of the clock of a round without a time limit.
void addAsClock(OverlayWriter& writer, const Scene& scene, const RunStatus& run, float width) {
  constexpr float kSize = 24;
  const auto& [seconds, arrived] = *scene.attempt;
  const std::string own = (arrived ? "★  Goal in " : "") + finishText(seconds);
  const glm::vec2 middle(width / 2, kFirstRow);
  writer.pill(own, middle, kSize, arrived ? kGold : kBright);
  if (run.difference) addDifference(writer, *run.difference, middle, writer.width(own, kSize) / 2 + kSize);
  const std::string best = bestTextOf(scene, run);
  if (!best.empty()) writer.pill(best, {middle.x, kSecondRow}, 14, kSoft);
}

}  // namespace

std::string differenceText(double seconds) {
  const long hundredths = std::lround(seconds * 100);
  const long magnitude = std::labs(hundredths);
  const std::string sign = hundredths > 0 ? "+" : hundredths < 0 ? "−" : "±";
  return sign + std::to_string(magnitude / 100) + (magnitude % 100 < 10 ? ".0" : ".") + std::to_string(magnitude % 100);
}

void addRunTimer(OverlayWriter& writer, const Scene& scene, const RunStatus& run, float width) {
  if (!scene.attempt) return;
  scene.timed ? addBelowClock(writer, scene, run, width) : addAsClock(writer, scene, run, width);
}

}  // namespace platon
