#include "client/ui/run_timer.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kTimeHeight = 36;

// The best time of the round, unless there is a best run, which counts more.
std::string bestTextOf(const Scene& scene, const RunStatus& run) {
  const auto& [seconds, arrived] = *scene.attempt;
  if (arrived && run.speed < 1) return slowedText(run.speed);
  if (arrived && run.isNewBest) return "new personal best";
  if (arrived && !run.notRecorded.empty()) return run.notRecorded;
  if (run.best) return "personal best " + finishText(*run.best);
  const std::optional<double> best = scene.players.back().finishSeconds;
  return best && !(arrived && *best == seconds) ? "best " + finishText(*best) : "";
}

}  // namespace

std::string differenceText(double seconds) {
  const long hundredths = std::lround(seconds * 100);
  const long magnitude = std::labs(hundredths);
  const std::string sign = hundredths > 0 ? "+" : hundredths < 0 ? "−" : "±";
  return sign + std::to_string(magnitude / 100) + (magnitude % 100 < 10 ? ".0" : ".") + std::to_string(magnitude % 100);
}

std::string slowedText(double speed) { return "at " + std::to_string(std::lround(speed * 100)) + " % speed, not kept"; }

std::optional<std::uint32_t> arrivalTicksOf(const Scene& scene) {
  if (!scene.attempt || !(scene.attempt->arrived || scene.teamSeconds)) return std::nullopt;
  return static_cast<std::uint32_t>(std::lround(scene.teamSeconds.value_or(scene.attempt->seconds) * kTicksPerSecond));
}

std::string ownMedalText(const Scene& scene, const std::optional<MedalTimes>& times) {
  const std::optional<std::uint32_t> ticks = arrivalTicksOf(scene);
  return times && ticks ? medalText(*times, *ticks) : "";
}

void addRunTimer(OverlayWriter& writer, const Scene& scene, const RunStatus& run, glm::vec2 place) {
  if (!scene.attempt) return;
  const auto& [seconds, arrived] = *scene.attempt;
  const float size = arrived ? 18 : scene.timed ? kSmallestText : 22;
  const std::string own = (arrived ? "✓ Goal in " : scene.timed ? "your time " : "") + finishText(seconds);
  const float end = writer.pillFrom(place.x, own, place.y, size, arrived ? kGold : scene.timed ? kSoft : kBright);
  if (run.difference)
    writer.pillFrom(end + 8, differenceText(*run.difference), place.y, 16, *run.difference <= 0 ? kGood : kWarning);
  const std::string best = bestTextOf(scene, run);
  if (!best.empty()) writer.pillFrom(place.x, best, place.y + kTimeHeight, kSmallestText, kSoft);
}

}  // namespace platon
