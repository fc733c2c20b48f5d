#include "client/hud/hud.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/hud/hud_space.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"
#include "client/ui/solid_text.h"

namespace platon {
namespace {

using namespace overlay_colours;

// Counter-clockwise from the right, each for an eighth of a turn around it.
constexpr std::array<const char*, 8> kArrows{"→", "↗", "↑", "↖", "←", "↙", "↓", "↘"};

const char* arrowOf(glm::dvec2 direction) {
  const double eighths = std::atan2(-direction.y, direction.x) * 4 / std::numbers::pi;
  return kArrows[static_cast<std::size_t>(std::lround(eighths) + 8) % kArrows.size()];
}

constexpr float kHelpMargin = 16;
constexpr float kHelpSize = kSmallestText;
constexpr float kHelpRowHeight = 22;
constexpr float kHelpGap = 18;

using Row = std::array<std::string, 3>;  // keys, button of a gamepad, meaning

// The keys of who shares the keyboard with the first player; with a gamepad one has the buttons of the table.
std::string keysBeside(std::span<const KeyHints> companions) {
  const auto keys = std::find_if_not(companions.begin(), companions.end(), std::mem_fn(&KeyHints::gamepad));
  if (keys == companions.end()) return {};
  std::string text = keys->sides();
  for (const Control control : {Control::kUp, Control::kDown, Control::kRestart}) text += " " + keys->of(control);
  return text;
}

// `brief`: one key or button of each control.
std::vector<Row> rowsOf(const KeyHints& hints, std::span<const KeyHints> companions, bool brief) {
  const auto keys = [&](Control control) { return brief ? hints.of(control) : hints.keys(control); };
  const auto pad = [brief](const std::string& button) { return brief ? std::string() : button; };
  const auto row = [&](Control control, const char* meaning) {
    return Row{keys(control), pad(hints.pad(control)), meaning};
  };
  std::string emotes;
  for (const Control control : {Control::kEmote1, Control::kEmote2, Control::kEmote3, Control::kEmote4})
    emotes += (emotes.empty() ? "" : " ") + hints.of(control);
  const std::string run = brief ? hints.sides() : hints.run();
  std::vector<Row> rows{{run, pad("stick: 3 speeds"), "run"},
                        row(Control::kSlow, "run slower"),
                        row(Control::kJump, "jump; hold to jump higher"),
                        row(Control::kUp, "jump, or move up the screen"),
                        row(Control::kDown, "fall faster"),
                        {keys(Control::kLook) + " and " + hints.lookWays(), pad("right stick"), "look round the solid"},
                        row(Control::kRestart, "back to the start"),
                        row(Control::kVote, "next level, or a vote for it"),
                        row(Control::kWatch, "after the goal: watch others"),
                        row(Control::kSay, "talk to all players"),
                        {"F2", pad(hints.joinPad()), "another player joins, or leaves"},
                        {emotes, "", "wave, laugh, here!, thanks"},
                        {"F1", "", "help"},
                        {"F3", "", "connection graph"},
                        {"F11", "", "full screen"},
                        {"Esc", pad("Start"), "pause, settings, leave"}};
  const std::string beside = keysBeside(companions);
  if (!beside.empty()) rows.push_back({beside, "", "run, jump, fall, start: the other player"});
  return rows;
}

constexpr std::size_t kMaxRows = 12;
constexpr std::size_t kMaxResults = 8;
constexpr float kMargin = 16;
constexpr float kGap = 8;
constexpr float kChatSize = kSmallestText;
constexpr float kTextSize = 18;     // of messages and notices
constexpr float kWidestText = 640;  // of messages and notices

// The empty display.
HudSpace spaceFor(const HudStatus& status, const Font& font, float width) {
  HudSpace space(font, glm::vec2(width, Overlay::kHeight) / status.scale);
  space.reserveFoot(status.foot / status.scale);
  return space;
}

// What a function draws.
template <class Draw>
Overlay drawn(const Font& font, Draw draw) {
  OverlayWriter writer(font);
  draw(writer);
  return writer.take();
}

void addTitle(OverlayWriter& writer, const Scene& scene, const Font& font, float width) {
  constexpr float kSize = 24;
  const std::string solid = textOf(scene.stage->mesh.solid().kind());
  const std::string title = scene.stage->title.empty() ? solid : scene.stage->title;
  writer.left(fittedText(title, font, (width * 0.4F - kMargin) / kSize), {kMargin, kMargin + 18}, kSize, kBright);
  if (!scene.stage->title.empty()) writer.left(solid, {kMargin, kMargin + 42}, kSmallestText, kBright);
}

// `tripWidth`: for the round trip, at the right.
void addRow(OverlayWriter& writer, const PlayerDrawing& player, const Font& font, float right, float top,
            float tripWidth) {
  constexpr float kRowWidth = 256;
  const float left = right - kRowWidth - tripWidth;
  const glm::vec2 dot(left + 20, top + 13);
  if (player.local) writer.panel({left, top}, {right, top + 26}, 8, {0.30F, 0.36F, 0.55F, 0.55F});
  const float half = std::max(11.0F, writer.width(player.number, kSmallestText) / 2 + 4);
  const float baseline = dot.y + kSmallestText * Font::kCapitalHeight / 2;
  writer.panel(dot - glm::vec2(half, 11), dot + glm::vec2(half, 11), 11, glm::vec4(player.colour, 1));
  writer.centred(player.number, {dot.x, baseline}, kSmallestText, {0.05F, 0.05F, 0.08F, 1});
  const std::string time = player.finishSeconds ? "✓ " + finishText(*player.finishSeconds) : "";
  const float room = kRowWidth - 52 - (time.empty() ? 0 : writer.width(time, kSmallestText) + 12);
  writer.left(fittedText(shownNameOf(player), font, room / kSmallestText), {dot.x + 22, baseline}, kSmallestText,
              player.local ? kBright : kSoft);
  writer.right(time, {right - 10 - tripWidth, baseline}, kSmallestText, kGold);
  if (player.roundTripMs) writer.right(roundTripText(player), {right - 10, baseline}, kSmallestText, kSoft);
}

void addPlayers(OverlayWriter& writer, const std::vector<const PlayerDrawing*>& players, std::size_t rows,
                const Font& font, float width, float tripWidth) {
  const bool more = players.size() > rows;
  const float right = width - kMargin;
  const float height = 28.0F * static_cast<float>(rows + (more ? 1 : 0)) + 10;
  writer.panel({right - 268 - tripWidth, kMargin}, {right, kMargin + height}, 12, kPanel);
  float top = kMargin + 6;
  for (std::size_t i = 0; i < rows; ++i, top += 28) addRow(writer, *players[i], font, right - 6, top, tripWidth);
  if (more)
    writer.right(std::string("and ") + std::to_string(players.size() - rows) + " more", {right - 16, top + 19},
                 kSmallestText, kSoft);
}

// As many rows as there is room for. Players who have all a pane of their own, with their names in it, need no list,
// which would cover one.
void placePlayers(HudSpace& space, std::span<const HudPane> panes, const HudStatus& status, const Font& font) {
  const Scene& scene = *panes.front().scene;
  const std::vector<const PlayerDrawing*> players = inOrder(scene);
  const float width = space.screen().x;
  if (status.summary && !status.summary->waits) {
    for (std::size_t rows = kMaxResults + 1; rows-- > 0;) {
      const auto draw = [&](OverlayWriter& writer) {
        addResults(writer, scene, *status.summary, status.run, font, width, rows);
      };
      if (space.add(drawn(font, draw))) return;
    }
    return;
  }
  if (players.size() <= panes.size()) return;
  for (std::size_t rows = std::min(players.size(), kMaxRows); rows > 0; --rows) {
    const auto draw = [&](OverlayWriter& writer) {
      addPlayers(writer, players, rows, font, width, roundTripWidth(scene));
    };
    if (space.add(drawn(font, draw))) return;
  }
}

// On the virtual screen, of a point before the camera.
glm::vec2 onScreen(const HudPane& pane, glm::dvec3 point) {
  const glm::dvec4 clip = pane.camera->viewProjection() * glm::dvec4(point, 1);
  return pane.corner + glm::vec2((clip.x / clip.w + 1) / 2, (1 - clip.y / clip.w) / 2) * pane.size;
}

bool isWithin(const HudPane& pane, glm::vec2 place) {
  const glm::vec2 end = pane.corner + pane.size;
  return place.x >= pane.corner.x && place.y >= pane.corner.y && place.x <= end.x && place.y <= end.y;
}

// The place on the screen above a player; nothing if it is out of the pane, or if its face looks away from the camera,
// so that the solid hides it.
std::optional<glm::vec2> placeAbove(const PlayerDrawing& player, const HudPane& pane) {
  const Camera& camera = *pane.camera;
  if (glm::dot(player.pose.normal, camera.eye() - player.pose.position) <= 0) return std::nullopt;
  const glm::dvec3 above = player.pose.position + camera.up() * (StageModel::kPlayerRadius * 1.35);
  const glm::vec2 place = onScreen(pane, above);
  return isWithin(pane, place) ? std::optional(place) : std::nullopt;
}

void addNameTag(OverlayWriter& writer, const PlayerDrawing& player, glm::vec2 place) {
  if (player.name.empty()) return;
  writer.centred(shownNameOf(player), place, kSmallestText, glm::vec4(glm::mix(player.colour, Colour(1), 0.35F), 0.9F));
}

// The name of a ghost would hide the ball that the player steers.
bool coversLocalPlayer(const Scene& scene, const PlayerDrawing& ghost) {
  constexpr double kDistance = 3.5 * StageModel::kPlayerRadius;
  if (scene.players.empty() || !scene.players.back().local) return false;
  return glm::distance(scene.players.back().pose.position, ghost.pose.position) < kDistance;
}

void placeNameTags(HudSpace& space, const HudPane& pane, const Font& font) {
  const Scene& scene = *pane.scene;
  const auto place = [&](const PlayerDrawing& player) {
    if (player.local && !pane.namesAll) return;
    const std::optional<glm::vec2> above = placeAbove(player, pane);
    if (above) space.addOver(drawn(font, [&](OverlayWriter& writer) { addNameTag(writer, player, *above); }));
  };
  for (const PlayerDrawing& ghost : scene.ghosts) {
    if (!coversLocalPlayer(scene, ghost)) place(ghost);
  }
  for (const PlayerDrawing& player : scene.players) place(player);
}

// In a long fall the own ball is small, and half of the time behind the solid.
void placeRing(HudSpace& space, const HudPane& pane, const Font& font) {
  constexpr float kSize = 44;
  const Scene& scene = *pane.scene;
  if (!scene.longFall || scene.players.empty()) return;
  const PlayerDrawing& player = scene.players.back();
  const glm::vec2 place = onScreen(pane, player.pose.position);
  space.addOver(drawn(font, [&](OverlayWriter& writer) {
    writer.centred("\u25cb", place + glm::vec2(0, kSize * Font::kCapitalHeight / 2), kSize,
                   glm::vec4(glm::mix(player.colour, Colour(1), 0.35F), 0.9F));
  }));
}

// Bubbles with what players say, above their names.
void placeBubbles(HudSpace& space, const HudPane& pane, const Font& font) {
  constexpr float kRise = 34;
  for (const PlayerDrawing& player : pane.scene->players) {
    const std::optional<glm::vec2> above = player.says.empty() ? std::nullopt : placeAbove(player, pane);
    if (!above) continue;
    const glm::vec4 colour(glm::mix(player.colour, Colour(1), 0.5F), 1);
    space.addOver(drawn(font, [&](OverlayWriter& writer) {
      writer.pill(player.says, *above - glm::vec2(0, kRise), kTextSize, colour);
    }));
  }
}

// At the border, or nearer to the middle if there is no room.
void placeSign(HudSpace& space, const HudPane& pane, glm::dvec3 point, const std::string& name, glm::vec4 colour,
               const Font& font) {
  constexpr float kSize = kSmallestText;
  const glm::dvec4 clip = pane.camera->viewProjection() * glm::dvec4(point, 1);
  for (float part = 1; part > 0.5F; part -= 0.08F) {
    const glm::vec2 half(font.width(name + "  ") * kSize / 2 + 3 * kSize, 2 * kSize);
    const auto sign = edgeSignOf(clip, pane.size, glm::max((pane.size / 2.0F - half) * part, glm::vec2(1)));
    if (!sign) return;
    const auto draw = [&](OverlayWriter& writer) {
      writer.pill(std::string(sign->arrow) + " " + name, pane.corner + sign->place, kSize, colour);
    };
    if (space.add(drawn(font, draw))) return;
  }
}

// Show where the goal and the other players are when they are out of the picture.
void placeSigns(HudSpace& space, const HudPane& pane, const Font& font) {
  const StageModel& stage = *pane.scene->stage;
  const Marker& goal = stage.goal;
  placeSign(space, pane, stage.mesh.pose(goal.face, goal.place, goal.angle).position, "★ goal", kGold, font);
  for (const PlayerDrawing& player : pane.scene->players) {
    const glm::vec4 colour(glm::mix(player.colour, Colour(1), 0.35F), 1);
    if (!player.local) placeSign(space, pane, player.pose.position, shownNameOf(player), colour, font);
  }
}

// At the upper edge of the pane; below what stands there.
void placeOwner(HudSpace& space, const HudPane& pane, const Font& font) {
  if (pane.scene->players.empty() || !pane.scene->players.back().local) return;
  const PlayerDrawing& player = pane.scene->players.back();
  const glm::vec4 colour(glm::mix(player.colour, Colour(1), 0.35F), 1);
  for (float below = 24; below < pane.size.y / 2; below += 8) {
    const glm::vec2 place = pane.corner + glm::vec2(pane.size.x / 2, below);
    const auto draw = [&](OverlayWriter& writer) { writer.pill(shownNameOf(player), place, kSmallestText, colour); };
    if (space.add(drawn(font, draw))) return;
  }
}

// At the lower edge of the pane of a companion; the first player reads it among the texts.
void placeRestart(HudSpace& space, const HudPane& pane, const KeyHints& keys, const Font& font) {
  if (!pane.scene->needsRestart) return;
  const glm::vec2 middle(pane.corner.x + pane.size.x / 2, pane.corner.y + pane.size.y - 40);
  space.add(drawn(font, [&](OverlayWriter& writer) {
    writer.pill(keys.to(Control::kRestart, "back to the start"), middle, kTextSize, kBright);
  }));
}

// At the left below the title. The results tell the times of a round that has ended.
void addTimes(OverlayWriter& writer, const Scene& scene, const HudStatus& status) {
  constexpr float kFirstRow = 90;
  constexpr float kSecondRow = 126;
  if (status.summary && (!status.summary->waits || showsOwnResult(scene, *status.summary))) return;
  const glm::vec4 clock = scene.secondsLeft < 10 ? kWarning : kBright;
  if (scene.timed) writer.pillFrom(kMargin, clockText(scene.secondsLeft), kFirstRow, 20, clock);
  const bool arrived = scene.attempt && scene.attempt->arrived;
  const glm::vec2 own(kMargin, scene.timed ? kSecondRow : kFirstRow);
  if (status.timer || arrived) addRunTimer(writer, scene, status.run, own);
}

void addVote(OverlayWriter& writer, const VoteStatus& vote, const KeyHints& keys, float top) {
  constexpr float kSize = kSmallestText;
  const std::string text = std::to_string(vote.votes) + " of " + std::to_string(vote.voters) +
                           (vote.votes == 1 ? " wants" : " want") + " the next level (" + keys.of(Control::kVote) + ")";
  const std::string shown = vote.mine ? "✓ " + text : text;
  writer.pillFrom(kMargin, shown, top + kSize, kSize, vote.mine ? kGold : kBright);
}

// Lines of a message or a notice of any length.
std::vector<std::string> linesOf(const std::string& text, const Font& font, float width, float size) {
  return wrapText(text, font, std::min(kWidestText, width - 4 * kMargin) / size);
}

std::string hintOf(const Scene& scene, const HudStatus& status) {
  if (scene.needsRestart) return status.keys.to(Control::kRestart, "back to the start");
  if (scene.neededPlayers == 0) {
    const std::string medal = ownMedalText(scene, status.medals);
    return medal + (medal.empty() || status.hint.empty() ? "" : " · ") + status.hint;
  }
  return "This level needs " + std::to_string(scene.neededPlayers) + " players. " + status.keys.join() +
         ": another one joins here · " + status.keys.to(Control::kVote, "next level");
}

void addChat(OverlayWriter& writer, std::span<const std::string> lines, float bottom) {
  constexpr float kHeight = 24;
  float widest = 0;
  for (const std::string& line : lines) widest = std::max(widest, writer.width(line, kChatSize));
  const glm::vec2 size(widest + 28, kHeight * static_cast<float>(lines.size()) + 14);
  const float top = bottom - size.y;
  writer.panel({kMargin, top}, glm::vec2(kMargin, top) + size, 12, kPanel);
  glm::vec2 place(kMargin + 14, top + 24);
  for (const std::string& line : lines) {
    writer.left(line, place, kChatSize, kBright);
    place.y += kHeight;
  }
}

// In the lower left corner, or above what stands there; the newest lines at the bottom, as many as there is room for.
void placeChat(HudSpace& space, const std::vector<std::string>& chat, const Font& font) {
  const float width = std::min(360.0F, space.screen().x * 0.45F);
  std::vector<std::string> lines;
  for (const std::string& said : chat) {
    for (std::string& line : wrapText(said, font, width / kChatSize)) lines.push_back(std::move(line));
  }
  for (std::size_t first = 0; first < lines.size(); ++first) {
    for (const float bottom : {space.screen().y - kMargin, space.startOfFoot() - kGap}) {
      const auto draw = [&](OverlayWriter& writer) { addChat(writer, std::span(lines).subspan(first), bottom); };
      if (space.add(drawn(font, draw))) return;
    }
  }
}

// At the lower left. Returns whether there was room.
bool placeHelp(HudSpace& space, const HudStatus& status, const Font& font, bool brief = false) {
  const auto draw = [&](OverlayWriter& writer) { addHelp(writer, status.keys, status.companionKeys, brief); };
  const Overlay help = drawn(font, draw);
  const HudBox box = boundsOf(help, font);
  const glm::vec2 place(kMargin, space.startOfFoot() - kGap - (box.high.y - box.low.y));
  return space.add(movedBy(help, place - box.low));
}

// The help instead of what it has no room beside, as long as the player asks for it.
HudSpace helpAlone(const HudStatus& status, const Font& font, float width) {
  HudSpace space = spaceFor(status, font, width);
  if (!placeHelp(space, status, font)) placeHelp(space, status, font, true);
  return space;
}

// At the lower right, or above what stands there.
void placeGraph(HudSpace& space, const NetGraph& graph, const Font& font) {
  const glm::vec2 corner(0, space.screen().y - Overlay::kHeight);
  const Overlay part = movedBy(graph.overlay(font, space.screen().x), corner);
  const float up = space.screen().y - space.startOfFoot();
  if (!space.add(part)) space.add(movedBy(part, {0, -up}));
}

bool hasOwnResult(const Scene& scene, const HudStatus& status) {
  return status.summary && showsOwnResult(scene, *status.summary);
}

// What the player may do.
std::string actionOf(const Scene& scene, const HudStatus& status, const Font& font) {
  return hasOwnResult(scene, status) ? ownKeysOf(*status.summary, status.keys, font) : hintOf(scene, status);
}

// In the upper half, below the title, or in the lower one if the ball, and with it the goal, would be behind it; where
// there is little room, without its headline.
void placeOwnResult(HudSpace& space, const HudPane& pane, const HudStatus& status, const Font& font) {
  constexpr float kTop = 76;
  constexpr float kGapBelow = 20;
  constexpr float kBelow = 130;  // at the lower edge, for other texts
  const Scene& scene = *pane.scene;
  OwnResult result = ownResultOf(scene, status.run, status.medals);
  const auto panel = [&] {
    return drawn(font, [&](OverlayWriter& writer) { addOwnResult(writer, result, {space.screen().x / 2, kTop}); });
  };
  const Overlay whole = panel();
  const HudBox box = boundsOf(whole, font);
  const bool coversBall =
      !scene.players.empty() && onScreen(pane, scene.players.back().pose.position).y < box.high.y + kGapBelow;
  if (coversBall && space.add(movedBy(whole, {0, space.startOfFoot() - kBelow - box.high.y}))) return;
  if (space.add(whole)) return;
  result.headline.clear();
  space.add(panel());
}

// At the lower edge the message, above it the notice, and above that what the player may do.
// `width`: of the part of the screen at the left to which what the player may do belongs.
void placeTexts(HudSpace& space, const HudStatus& status, const std::string& action, const Font& font, float width) {
  glm::vec2 middle(space.screen().x / 2, space.startOfFoot() - 40);
  const auto add = [&](const std::string& text, glm::vec4 colour, float room) {
    const std::vector<std::string> lines = linesOf(text, font, room, kTextSize);
    if (lines.empty()) return;
    float top = 0;
    const auto draw = [&](OverlayWriter& writer) { top = writer.pill(lines, middle, kTextSize, colour); };
    if (space.add(drawn(font, draw))) middle.y = top - 1.4F * kTextSize;
  };
  add(status.message, status.warning ? kWarning : kBright, space.screen().x);
  add(status.notice, kGold, space.screen().x);
  middle.x = width / 2;
  add(action, kBright, width);
}

}  // namespace

std::optional<EdgeSign> edgeSignOf(glm::dvec4 clip, glm::vec2 screen, glm::vec2 reach) {
  const bool before = clip.w > 0;
  if (before && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w) return std::nullopt;
  // What is behind the camera is projected to the opposite side.
  const double side = before ? 1 : -1;
  glm::dvec2 way(side * clip.x * screen.x, -side * clip.y * screen.y);
  if (glm::length(way) < 1e-9) way = {0, 1};
  const glm::dvec2 direction = glm::normalize(way);
  const double toSide = reach.x / std::max(std::abs(direction.x), 1e-9);
  const double toTop = reach.y / std::max(std::abs(direction.y), 1e-9);
  const glm::vec2 place = screen / 2.0F + glm::vec2(direction * std::min(toSide, toTop));
  return EdgeSign{glm::vec2(direction), place, arrowOf(direction)};
}

void addHelp(OverlayWriter& writer, const KeyHints& keys, std::span<const KeyHints> companions, bool brief) {
  const std::vector<Row> rows = rowsOf(keys, companions, brief);
  std::array<float, 3> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!row[i].empty()) widths[i] = std::max(widths[i], writer.width(row[i], kHelpSize) + kHelpGap);
    }
  }
  const glm::vec2 size(widths[0] + widths[1] + widths[2] + kHelpGap,
                       kHelpRowHeight * static_cast<float>(rows.size()) + 20);
  const glm::vec2 low(kHelpMargin, Overlay::kHeight - kHelpMargin - size.y);
  writer.panel(low, low + size, 12, kPanel);
  glm::vec2 place = low + glm::vec2(kHelpGap, 27);
  for (const auto& [key, pad, meaning] : rows) {
    writer.left(key, place, kHelpSize, kBright);
    writer.left(pad, place + glm::vec2(widths[0], 0), kHelpSize, kBright);
    writer.left(meaning, place + glm::vec2(widths[0] + widths[1], 0), kHelpSize, kSoft);
    place.y += kHelpRowHeight;
  }
}

std::string clockText(double seconds) {
  if (seconds < 10) {
    const auto tenths = static_cast<long>(std::ceil(seconds * 10 - 1e-6));
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
  }
  const auto whole = static_cast<long>(std::ceil(seconds - 1e-6));
  return std::to_string(whole / 60) + ":" + twoDigits(whole % 60);
}

Overlay makeEmptyHud(const HudStatus& status, const Font& font, float width) {
  HudSpace space = spaceFor(status, font, width);
  const glm::vec2 screen = space.screen();
  placeTexts(space, {.notice = status.notice}, {}, font, screen.x);
  space.add(drawn(font, [&](OverlayWriter& writer) {
    writer.centred("Platon", {screen.x / 2, screen.y * 0.44F}, 64, kBright);
    const std::vector<std::string> lines = linesOf(status.message, font, screen.x, kTextSize);
    if (lines.empty()) return;
    const float below = 1.3F * kTextSize * static_cast<float>(lines.size() - 1);
    writer.pill(lines, {screen.x / 2, screen.y * 0.44F + 54 + below}, kTextSize, status.warning ? kWarning : kBright);
  }));
  if (status.help) placeHelp(space, status, font);
  return scaledBy(space.overlay(), status.scale);
}

Overlay makeNotice(const std::string& notice, const Font& font, float width, float scale) {
  HudSpace space = spaceFor({.scale = scale}, font, width);
  placeTexts(space, {.notice = notice}, {}, font, space.screen().x);
  return scaledBy(space.overlay(), scale);
}

namespace {

// `width`: of the virtual screen at scale 1. The first pane tells what is told once.
Overlay hudOf(std::span<const HudPane> panes, const HudStatus& status, const Font& font, float width) {
  const Scene& scene = *panes.front().scene;
  HudSpace space = spaceFor(status, font, width);
  const glm::vec2 screen = space.screen();
  placeTexts(space, status, status.underMenu ? "" : actionOf(scene, status, font), font, panes.front().size.x);
  if (status.underMenu) return scaledBy(space.overlay(), status.scale);
  if (hasOwnResult(scene, status)) placeOwnResult(space, panes.front(), status, font);
  space.add(drawn(font, [&](OverlayWriter& writer) { addTitle(writer, scene, font, screen.x); }));
  space.add(drawn(font, [&](OverlayWriter& writer) { addTimes(writer, scene, status); }));
  if (status.vote) {
    const float top = space.endOfColumn(false) + kGap;
    space.add(drawn(font, [&](OverlayWriter& writer) { addVote(writer, *status.vote, status.keys, top); }));
  }
  if (status.help && !placeHelp(space, status, font)) space = helpAlone(status, font, width);
  if (status.netGraph != nullptr) placeGraph(space, *status.netGraph, font);
  placePlayers(space, panes, status, font);
  placeChat(space, status.chat, font);
  if (status.assembling) return scaledBy(space.overlay(), status.scale);
  for (std::size_t i = 1; i < std::min(panes.size(), status.companionKeys.size() + 1); ++i)
    placeRestart(space, panes[i], status.companionKeys[i - 1], font);
  for (const HudPane& pane : panes) {
    if (panes.size() > 1) placeOwner(space, pane, font);
    placeSigns(space, pane, font);
    placeNameTags(space, pane, font);
    placeRing(space, pane, font);
    placeBubbles(space, pane, font);
  }
  return scaledBy(space.overlay(), status.scale);
}

}  // namespace

Overlay makeHud(const Scene& scene, const Camera& camera, const HudStatus& status, const Font& font) {
  const float width = Overlay::widthFor(camera.width(), camera.height());
  const HudPane pane{&scene, &camera, {0, 0}, glm::vec2(width, Overlay::kHeight) / status.scale};
  return hudOf({&pane, 1}, status, font, width);
}

Overlay makeSharedHud(std::span<const HudPane> panes, const HudStatus& status, const Font& font, float width) {
  std::vector<HudPane> scaled(panes.begin(), panes.end());
  for (HudPane& pane : scaled) {
    pane.corner /= status.scale;
    pane.size /= status.scale;
    pane.namesAll = panes.size() == 1;
  }
  return hudOf(scaled, status, font, width);
}

}  // namespace platon
