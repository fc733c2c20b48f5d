#include "client/hud/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/ui/key_help.h"
#include "client/ui/overlay_writer.h"
#include "client/ui/player_rows.h"
#include "client/ui/text_wrap.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr std::size_t kMaxRows = 12;
constexpr float kMargin = 16;
constexpr float kTextSize = 18;     // of messages and notices
constexpr float kWidestText = 640;  // of messages and notices

std::string twoDigits(long value) { return std::string(value < 10 ? "0" : "") + std::to_string(value); }

void addTitle(OverlayWriter& writer, const Scene& scene) {
  const std::string solid(nameOf(scene.stage->mesh.solid().kind()));
  const std::string title = scene.stage->title.empty() ? solid : scene.stage->title;
  writer.left(title, {kMargin, kMargin + 22}, 24, kBright);
  if (!scene.stage->title.empty()) writer.left(solid, {kMargin, kMargin + 42}, 12, kSoft);
}

void addClock(OverlayWriter& writer, const Scene& scene, float width) {
  const bool urgent = scene.secondsLeft < 10;
  writer.pill(clockText(scene.secondsLeft), {width / 2, kMargin + 22}, 26, urgent ? kWarning : kBright);
}

void addRow(OverlayWriter& writer, const PlayerDrawing& player, float right, float top) {
  constexpr float kRowWidth = 232;
  const glm::vec2 dot(right - kRowWidth + 16, top + 13);
  if (player.local) writer.panel({right - kRowWidth, top}, {right, top + 26}, 8, {0.30F, 0.36F, 0.55F, 0.55F});
  writer.panel(dot - 9.0F, dot + 9.0F, 9, glm::vec4(player.colour, 1));
  const float size = player.number.size() > 2 ? 9 : 11;
  writer.centred(player.number, {dot.x, dot.y + size * 0.36F}, size, {0.05F, 0.05F, 0.08F, 1});
  writer.left(shownNameOf(player), {dot.x + 18, top + 18}, 15, player.local ? kBright : kSoft);
  if (player.finishSeconds)
    writer.right(std::string("✓ ") + finishText(*player.finishSeconds), {right - 10, top + 18}, 13, kGold);
}

void addPlayers(OverlayWriter& writer, const Scene& scene, float width) {
  const std::vector<const PlayerDrawing*> players = inOrder(scene);
  if (players.size() < 2) return;
  const std::size_t rows = std::min(players.size(), kMaxRows);
  const bool more = players.size() > rows;
  const float right = width - kMargin;
  const float height = 28.0F * static_cast<float>(rows + (more ? 1 : 0)) + 10;
  writer.panel({right - 244, kMargin}, {right, kMargin + height}, 12, kPanel);
  float top = kMargin + 6;
  for (std::size_t i = 0; i < rows; ++i, top += 28) addRow(writer, *players[i], right - 6, top);
  if (more)
    writer.right(std::string("and ") + std::to_string(players.size() - rows) + " more", {right - 16, top + 18}, 13,
                 kSoft);
}

void addNameTag(OverlayWriter& writer, const PlayerDrawing& player, const Camera& camera, float width) {
  if (player.local || player.name.empty()) return;
  // Players whose face looks away from the camera are hidden by the solid.
  if (glm::dot(player.pose.normal, camera.eye() - player.pose.position) <= 0) return;
  const glm::dvec3 above = player.pose.position + camera.up() * (StageModel::kPlayerRadius * 1.35);
  const glm::dvec4 clip = camera.viewProjection() * glm::dvec4(above, 1);
  const glm::vec2 place((clip.x / clip.w + 1) / 2 * width, (1 - clip.y / clip.w) / 2 * Overlay::kHeight);
  writer.centred(shownNameOf(player), place, 13, glm::vec4(glm::mix(player.colour, Colour(1), 0.35F), 0.9F));
}

// The name of a ghost would hide the ball that the player steers.
bool coversLocalPlayer(const Scene& scene, const PlayerDrawing& ghost) {
  constexpr double kDistance = 3.5 * StageModel::kPlayerRadius;
  if (scene.players.empty() || !scene.players.back().local) return false;
  return glm::distance(scene.players.back().pose.position, ghost.pose.position) < kDistance;
}

// At the top in the middle. The results tell the times of a round that has ended.
void addTimes(OverlayWriter& writer, const Scene& scene, const HudStatus& status, float width) {
  if (status.summary && (!status.summary->waits || showsOwnResult(scene, *status.summary))) return;
  if (scene.timed) addClock(writer, scene, width);
  const bool arrived = scene.attempt && scene.attempt->arrived;
  if (status.timer || arrived) addRunTimer(writer, scene, status.run, width);
}

void addVote(OverlayWriter& writer, const VoteStatus& vote, const KeyHints& keys, float width) {
  const std::string text = std::to_string(vote.votes) + " of " + std::to_string(vote.voters) +
                           (vote.votes == 1 ? " wants" : " want") + " the next level (" + keys.of(Control::kVote) + ")";
  writer.pill(vote.mine ? "✓ " + text : text, {width / 2, kMargin + 93}, 16, vote.mine ? kGold : kBright);
}

// Lines of a message or a notice of any length.
std::vector<std::string> linesOf(const std::string& text, const Font& font, float width, float size) {
  return wrapText(text, font, std::min(kWidestText, width - 4 * kMargin) / size);
}

std::string hintOf(const Scene& scene, const HudStatus& status) {
  if (scene.needsRestart) return status.keys.to(Control::kRestart, "back to the start");
  if (scene.neededPlayers == 0) return status.hint;
  return "This level needs " + std::to_string(scene.neededPlayers) + " players. " +
         status.keys.to(Control::kVote, "next level");
}

// At the left, in the middle of the height; the newest at the bottom.
void addChat(OverlayWriter& writer, const std::vector<std::string>& chat, const Font& font) {
  constexpr float kSize = 16;
  constexpr float kHeight = 24;
  constexpr float kWidth = 360;
  std::vector<std::string> lines;
  for (const std::string& said : chat) {
    for (std::string& line : wrapText(said, font, kWidth / kSize)) lines.push_back(std::move(line));
  }
  if (lines.empty()) return;
  float widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, writer.width(line, kSize));
  const float top = Overlay::kHeight * 0.55F - kHeight * static_cast<float>(lines.size());
  const glm::vec2 size(widest + 28, kHeight * static_cast<float>(lines.size()) + 14);
  writer.panel({kMargin, top}, glm::vec2(kMargin, top) + size, 12, kPanel);
  glm::vec2 place(kMargin + 14, top + 24);
  for (const std::string& line : lines) {
    writer.left(line, place, kSize, kBright);
    place.y += kHeight;
  }
}

// What the local player has reached and may do, one above the other from the lowest on.
struct LowerTexts {
  std::string keys;
  std::string reached{};
};

LowerTexts lowerTextsOf(const Scene& scene, const HudStatus& status, const Font& font) {
  if (!status.summary || !showsOwnResult(scene, *status.summary)) return {hintOf(scene, status)};
  return {ownKeysOf(*status.summary, status.keys, font), ownResultOf(scene, status.run)};
}

// At the lower edge the message, above it the notice, and above that what the player may do and has reached.
void addTexts(OverlayWriter& writer, const HudStatus& status, const LowerTexts& own, const Font& font, float width) {
  glm::vec2 middle(width / 2, Overlay::kHeight - 40);
  const auto add = [&](const std::string& text, glm::vec4 colour) {
    const std::vector<std::string> lines = linesOf(text, font, width, kTextSize);
    if (!lines.empty()) middle.y = writer.pill(lines, middle, kTextSize, colour) - 1.4F * kTextSize;
  };
  add(status.message, status.warning ? kWarning : kBright);
  add(status.notice, kGold);
  add(own.keys, kBright);
  add(own.reached, kGold);
}

}  // namespace

std::string clockText(double seconds) {
  if (seconds < 10) {
    const auto tenths = static_cast<long>(std::ceil(seconds * 10 - 1e-6));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }
  const auto whole = static_cast<long>(std::ceil(seconds - 1e-6));
  return std::to_string(whole / 60) + ":" + twoDigits(whole % 60);
}

Overlay makeEmptyHud(const HudStatus& status, const Font& font, float width) {
  OverlayWriter writer(font);
  writer.centred("Platon", {width / 2, Overlay::kHeight * 0.44F}, 64, kBright);
  glm::vec2 place(width / 2, Overlay::kHeight * 0.52F);
  for (const std::string& line : linesOf(status.message, font, width, 20)) {
    writer.centred(line, place, 20, status.warning ? kWarning : kSoft);
    place.y += 26;
  }
  if (status.help) addHelp(writer, status.keys);
  addTexts(writer, {.notice = status.notice}, {}, font, width);
  return writer.take();
}

Overlay makeHud(const Scene& scene, const Camera& camera, const HudStatus& status, const Font& font) {
  OverlayWriter writer(font);
  const float width = Overlay::widthFor(camera.width(), camera.height());
  if (status.underMenu) {
    addTexts(writer, status, {}, font, width);
    return writer.take();
  }
  for (const PlayerDrawing& ghost : scene.ghosts) {
    if (!coversLocalPlayer(scene, ghost)) addNameTag(writer, ghost, camera, width);
  }
  for (const PlayerDrawing& player : scene.players) addNameTag(writer, player, camera, width);
  addTitle(writer, scene);
  addTimes(writer, scene, status, width);
  if (status.summary && !status.summary->waits)
    addResults(writer, scene, *status.summary, font, width);
  else
    addPlayers(writer, scene, width);
  if (status.vote) addVote(writer, *status.vote, status.keys, width);
  if (status.help) addHelp(writer, status.keys);
  addChat(writer, status.chat, font);
  addTexts(writer, status, lowerTextsOf(scene, status, font), font, width);
  return writer.take();
}

}  // namespace platon
