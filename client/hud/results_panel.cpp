#include "client/hud/results_panel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "client/ui/player_rows.h"
#include "client/ui/text_wrap.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr std::size_t kMaxRows = 8;
constexpr float kTop = Overlay::kHeight * 0.26F;
constexpr float kWidth = 420;
constexpr float kRowHeight = 28;
constexpr float kTextSize = 18;  // of what comes next
constexpr float kWidestText = 640;

std::string bestText(const RoundSummary& summary) {
  if (!summary.bestSeconds) return "Nobody has reached the goal of this level yet";
  return std::string(summary.bestIsNew ? "New best time: " : "Best time: ") + finishText(*summary.bestSeconds) + ", " +
         summary.bestName;
}

std::string nextText(const RoundSummary& summary) {
  const auto seconds = static_cast<long>(std::ceil(summary.secondsLeft - 1e-6));
  const std::string when = seconds > 0 ? " in " + std::to_string(seconds) + " s" : "";
  return "next: " + summary.nextTitle + when;
}

void addRow(OverlayWriter& writer, const PlayerDrawing& player, std::size_t place, glm::vec2 low) {
  const bool finished = player.finishSeconds.has_value();
  const glm::vec4 colour = player.local ? kBright : kSoft;
  const float baseline = low.y + 20;
  if (finished) writer.right(std::to_string(place) + ".", {low.x + 34, baseline}, 15, colour);
  writer.left(shownNameOf(player), {low.x + 46, baseline}, 15, colour);
  const std::string time = finished ? finishText(*player.finishSeconds) : "did not finish";
  writer.right(time, {low.x + kWidth - 16, baseline}, 15, finished ? kGold : kSoft);
}

}  // namespace

void addResults(OverlayWriter& writer, const Scene& scene, const RoundSummary& summary, const Font& font, float width) {
  const std::vector<const PlayerDrawing*> players = inOrder(scene);
  const std::size_t rows = std::min(players.size(), kMaxRows);
  const bool more = players.size() > rows;
  const float height = kRowHeight * static_cast<float>(rows + (more ? 2 : 1)) + 16;
  const glm::vec2 low((width - kWidth) / 2, kTop);
  writer.panel(low, low + glm::vec2(kWidth, height), 12, kPanel);
  glm::vec2 place = low + glm::vec2(0, 6);
  for (std::size_t i = 0; i < rows; ++i, place.y += kRowHeight) addRow(writer, *players[i], i + 1, place);
  if (more) {
    writer.left("and " + std::to_string(players.size() - rows) + " more", {place.x + 46, place.y + 20}, 13, kSoft);
    place.y += kRowHeight;
  }
  writer.centred(bestText(summary), {width / 2, place.y + 22}, 15, summary.bestIsNew ? kGold : kSoft);
  const std::vector<std::string> next =
      wrapText(nextText(summary), font, std::min(kWidestText, width - 64) / kTextSize);
  const float lines = static_cast<float>(next.size());
  writer.pill(next, {width / 2, low.y + height + 1.3F * kTextSize * lines + 8}, kTextSize, kBright);
}

}  // namespace platon
