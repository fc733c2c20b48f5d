#include "client/hud/results_panel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kPanelEdge = 16;
constexpr float kPanelWidth = 310;
constexpr float kPanelPadding = 14;
constexpr float kPanelRowHeight = 25;
constexpr float kPanelTextSize = kSmallestText;
constexpr float kTimeWidth = 90;

std::string bestText(const RoundSummary& summary) {
  if (!summary.bestSeconds) return "Nobody has reached the goal yet";
  if (summary.bestIsNew) return "New best time: " + summary.bestName;
  return "Best time " + finishText(*summary.bestSeconds) + ", " + summary.bestName;
}

// What a time has given, and up to which time there is more.
std::string medalLineOf(const MedalTimes& times, Medal medal) {
  const auto inTime = [](std::uint32_t ticks) { return " in " + finishTextOf(ticks) + " or less"; };
  switch (medal) {
    case Medal::kGold:
      return "Gold medal";
    case Medal::kSilver:
      return "Silver medal. Gold" + inTime(times.gold);
    case Medal::kBronze:
      return "Bronze medal. Silver" + inTime(times.silver);
    default:
      return "Bronze medal" + inTime(times.bronze);
  }
}

std::string nextTitleOf(const RoundSummary& summary, const Font& font, float width) {
  return fittedText(summary.nextTitle, font, width / kPanelTextSize);
}

std::string nextText(const RoundSummary& summary, const Font& font) {
  const auto seconds = static_cast<long>(std::ceil(summary.secondsLeft - 1e-6));
  const std::string when = seconds > 0 ? " in " + std::to_string(seconds) + " s" : "";
  return "Next level" + when + ": " + nextTitleOf(summary, font, 1.5F * (kPanelWidth - 2 * kPanelPadding));
}

// `tripWidth`: for the round trip, right of the time.
// `place`: nothing in a team, which has no ranks.
void addResult(OverlayWriter& writer, const PlayerDrawing& player, std::optional<std::size_t> place, glm::vec2 start,
               float tripWidth, const Font& font) {
  const bool finished = player.finishSeconds.has_value();
  const glm::vec4 colour = player.local ? kBright : kSoft;
  const float right = start.x + kPanelWidth - 2 * kPanelPadding;
  const float nameWidth = right - kTimeWidth - (start.x + 32);
  if (finished && place) writer.right(std::to_string(*place) + ".", {start.x + 22, start.y}, kPanelTextSize, colour);
  writer.left(fittedText(shownNameOf(player), font, nameWidth / kPanelTextSize), {start.x + 32, start.y},
              kPanelTextSize, colour);
  const std::string reached = place ? (finished ? finishText(*player.finishSeconds) : "–") : (finished ? "✓" : "–");
  writer.right(reached, {right, start.y}, kPanelTextSize, finished ? kGold : kSoft);
  if (player.roundTripMs) writer.right(roundTripText(player), {right + tripWidth, start.y}, kPanelTextSize, kSoft);
}

}  // namespace

bool showsOwnResult(const Scene& scene, const RoundSummary& summary) { return summary.waits && arrivalTicksOf(scene); }

OwnResult ownResultOf(const Scene& scene, const RunStatus& run, const std::optional<MedalTimes>& medals) {
  OwnResult result;
  result.headline = scene.isTeam ? "Together at the goal!" : "Goal!";
  result.time = finishText(scene.teamSeconds.value_or(scene.attempt->seconds));
  if (run.speed < 1) {
    result.time += " " + slowedText(run.speed);
    return result;
  }
  if (run.isNewBest && !scene.isTeam) result.headline = run.difference ? "New best time!" : "Level complete!";
  if (run.difference && !scene.isTeam) result.time += " (" + differenceText(*run.difference) + " s)";
  if (!run.notRecorded.empty()) result.time += ", " + run.notRecorded;
  if (!medals) return result;
  const std::uint32_t ticks = *arrivalTicksOf(scene);
  const Medal medal = medalFor(*medals, ticks);
  if (medal != Medal::kNone) result.stars = starsOf(medal);
  result.colour = colourOf(medal);
  result.medal = medalLineOf(*medals, medal);
  return result;
}

void addOwnResult(OverlayWriter& writer, const OwnResult& result, glm::vec2 top) {
  constexpr float kPadding = 18;
  constexpr float kSpacing = 1.35F;  // of the lines, for a text of size 1
  struct Line {
    std::string text;
    float size;
    glm::vec4 colour;
  };
  std::vector<Line> lines{{result.headline, 34, kBright},
                          {result.stars, 60, result.colour},
                          {result.time, 24, kGold},
                          {result.medal, 18, kBright}};
  std::erase_if(lines, [](const Line& line) { return line.text.empty(); });
  float width = 0;
  float height = kPadding;
  for (const Line& line : lines) {
    width = std::max(width, writer.width(line.text, line.size));
    height += kSpacing * line.size;
  }
  const glm::vec2 half(width / 2 + 2 * kPadding, 0);
  writer.panel(top - half, top + half + glm::vec2(0, height), kPadding, kPanel);
  top.y += kPadding / 2;
  for (const Line& line : lines) {
    writer.centred(line.text, {top.x, top.y + line.size}, line.size, line.colour);
    top.y += kSpacing * line.size;
  }
}

std::string ownKeysOf(const RoundSummary& summary, const KeyHints& keys, const Font& font) {
  return keys.goOn() + ": next level (" + nextTitleOf(summary, font, kPanelWidth) + ") · " +
         keys.to(Control::kRestart, "try again") + " · " + keys.menu() + ": menu";
}

void addResults(OverlayWriter& writer, const Scene& scene, const RoundSummary& summary, const RunStatus& run,
                const Font& font, float width, std::size_t maxRows) {
  const std::vector<const PlayerDrawing*> players = inOrder(scene);
  const std::size_t rows = std::min(players.size(), maxRows);
  const bool more = players.size() > rows;
  std::vector<std::string> below =
      wrapText(bestText(summary), font, (kPanelWidth - 2 * kPanelPadding) / kPanelTextSize);
  if (run.speed < 1 && scene.attempt && scene.attempt->arrived)
    below.insert(below.begin(), "Your time: " + slowedText(run.speed));
  if (scene.teamSeconds) below.insert(below.begin(), "Together: " + finishText(*scene.teamSeconds));
  const std::size_t bestLines = below.size();
  for (std::string& line : wrapText(nextText(summary, font), font, (kPanelWidth - 2 * kPanelPadding) / kPanelTextSize))
    below.push_back(std::move(line));
  const std::size_t lines = 1 + rows + (more ? 1 : 0) + below.size();
  const float tripWidth = roundTripWidth(scene);
  const glm::vec2 low(width - kPanelEdge - kPanelWidth - tripWidth, kPanelEdge);
  writer.panel(low, low + glm::vec2(kPanelWidth + tripWidth, kPanelRowHeight * static_cast<float>(lines) + 16), 12,
               kPanel);
  glm::vec2 place = low + glm::vec2(kPanelPadding, 26);
  writer.left(scene.secondsLeft <= 0 ? "Time is up" : "Round over", place, kPanelTextSize, kBright);
  for (std::size_t i = 0; i < rows; ++i)
    addResult(writer, *players[i], scene.isTeam ? std::nullopt : std::optional(i + 1),
              place += glm::vec2(0, kPanelRowHeight), tripWidth, font);
  if (more)
    writer.left("and " + std::to_string(players.size() - rows) + " more",
                (place += glm::vec2(0, kPanelRowHeight)) + glm::vec2(32, 0), kPanelTextSize, kSoft);
  for (std::size_t i = 0; i < below.size(); ++i) {
    const glm::vec4 colour = i >= bestLines ? kBright : summary.bestIsNew ? kGold : kSoft;
    writer.left(below[i], place += glm::vec2(0, kPanelRowHeight), kPanelTextSize, colour);
  }
}

}  // namespace platon
