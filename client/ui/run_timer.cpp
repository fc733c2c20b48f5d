#include "client/ui/run_timer.h"

#include <cmath>
#include <cstdlib>

#include "client/ui/player_rows.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kTop = 78;  // middle of the own time
constexpr float kSize = 14;
constexpr float kDifferenceSize = 20;

// The best time of the round, unless there is a best run, which counts more.
std::string bestTextOf(const Scene& scene, const RunStatus& run) {
  const auto& [seconds, arrived] = *scene.attempt;
  if (run.best) return "   personal best " + finishText(*run.best);
  const std::optional<double> best = scene.players.back().finishSeconds;
  return best && !(arrived && *best == seconds) ? "   best " + finishText(*best) : "";
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
  const auto& [seconds, arrived] = *scene.attempt;
  const std::string own = std::string(arrived ? "✓ " : "") + "your time " + finishText(seconds);
  const bool isNew = arrived && run.isNewBest;
  const std::string best = isNew ? "   new personal best" : bestTextOf(scene, run);
  const glm::vec2 middle(width / 2, kTop);
  writer.pill(own + best, middle, kSize, arrived ? kGold : kSoft);
  if (!run.difference) return;
  // Beside the pill of the own time.
  const float half = writer.width(own + best, kSize) / 2 + kSize;
  const std::string text = differenceText(*run.difference);
  const float from = middle.x + half + kDifferenceSize + writer.width(text, kDifferenceSize) / 2 + 8;
  writer.pill(text, {from, kTop}, kDifferenceSize, *run.difference <= 0 ? kGood : kWarning);
}

}  // namespace platon
