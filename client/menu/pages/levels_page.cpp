#include "client/menu/pages/levels_page.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "client/menu/menu_layout.h"
#include "client/scene/camera_target.h"
#include "client/scene/view_point.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"
#include "protocol/texts.h"

namespace platon {
namespace {

using namespace overlay_colours;

// A row of the page: a level, or the heading of those that follow.
struct Row {
  std::string heading;
  std::size_t level = 0;  // for a heading, the level below it
};

std::string groupOf(const LevelEntry& level) {
  return level.players == 1 ? level.solid : "For " + std::to_string(level.players) + " players";
}

void addRow(std::vector<Row>& rows, std::string& group, std::span<const LevelEntry> levels, std::size_t level) {
  if (groupOf(levels[level]) != group) {
    group = groupOf(levels[level]);
    rows.push_back({group, level});
  }
  rows.push_back({"", level});
}

// By solid those for one player, then those for several.
std::vector<Row> rowsOf(std::span<const LevelEntry> levels) {
  std::vector<Row> rows;
  std::string group;
  for (const bool several : {false, true}) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if ((levels[i].players > 1) == several) addRow(rows, group, levels, i);
    }
  }
  return rows;
}

// Nothing: without a time, and on a level without medals.
std::optional<Medal> medalOf(const LevelEntry& level) {
  if (!level.medals || !level.bestTicks) return std::nullopt;
  return medalFor(*level.medals, *level.bestTicks);
}

// What the player has reached; a time of older rules gives no medal.
std::string reachedText(const LevelEntry& level) {
  if (level.bestTicks) return starsOf(medalOf(level)) + " " + finishTextOf(*level.bestTicks);
  const std::string reached = level.reached ? "✓" : "";
  if (!level.olderTicks) return reached;
  return reached + (level.reached ? " " : "") + finishTextOf(*level.olderTicks) + ", older rules";
}

std::string factsOf(const LevelEntry& level) {
  const std::string solid = level.players > 1 ? level.solid : "";
  const std::string reached = reachedText(level);
  return solid + (solid.empty() || reached.empty() ? "" : " · ") + reached;
}

MenuItem itemOf(const LevelEntry& level) {
  MenuItem item{.name = level.title, .value = factsOf(level)};
  if (const std::optional<Medal> medal = medalOf(level)) item.valueColour = colourOf(*medal);
  return item;
}

constexpr double kHeight = 0.45;     // of the eye, in distances from the axis, for a ball on an upright face
constexpr double kHeightUp = 0.1;    // more, for a ball on the top
constexpr double kHeightDown = 1.4;  // less, for a ball on the bottom
constexpr double kMostBelow = 0.55;
constexpr double kFollow = 1.2;       // rate of the turn to the ball, per second
constexpr double kMaxFollow = 0.5;    // radians a second
constexpr double kLead = 0.55;        // radians by which the face of the ball is aside of the front
constexpr double kSize = 0.77;        // half of the solid, in half shorter sides of the picture
constexpr double kSizeOfWidth = 0.5;  // at most, in half widths of a wide picture
constexpr double kSizeAlone = 0.7;    // where it is not beside a menu
constexpr double kAbove = 0.16;       // of the solid above the middle, in half heights, for the card below it
constexpr double kShift = 2 * Turntable::kMiddle - 1;  // of the solid, in half widths of the picture

constexpr float kTitle = 104;  // baselines above the lower edge of the screen
constexpr float kFacts = 74;
constexpr float kMedals = 40;
constexpr float kMargin = 24;
constexpr float kLeast = 100;  // room on each side of the middle

std::string medalText(Medal medal, std::uint32_t ticks) { return starsOf(medal) + " " + finishTextOf(ticks); }

// At most `room` to each side of `middle`.
void addMedals(OverlayWriter& writer, const MedalTimes& times, glm::vec2 middle, float room) {
  const std::pair<Medal, std::uint32_t> medals[]{
      {Medal::kGold, times.gold}, {Medal::kSilver, times.silver}, {Medal::kBronze, times.bronze}};
  float width = 0;
  for (const auto& [medal, ticks] : medals)
    width = std::max(width, writer.width(medalText(medal, ticks), kSmallestText) + 20);
  const glm::vec2 half(1.5F * width, 15);
  if (half.x > room) return;
  const glm::vec2 panel = middle - glm::vec2(0, kSmallestText * Font::kCapitalHeight / 2);
  writer.panel(panel - half, panel + half, half.y, kPanel);
  float x = middle.x - width;
  for (const auto& [medal, ticks] : medals) {
    writer.centred(medalText(medal, ticks), {x, middle.y}, kSmallestText, colourOf(medal));
    x += width;
  }
}

// Largest distance of a part of the solid from the middle of the picture as it turns below the eye.
double reachOf(const SolidMesh& mesh) {
  const double tilt = std::atan(kHeight + kHeightUp);
  double reach = 0;
  for (int face = 0; face < mesh.faces(); ++face) {
    for (const glm::dvec2 corner : mesh.polygon()) {
      const glm::dvec3 point = mesh.toWorld(face, corner);
      const double aside = std::hypot(point.x, point.z);
      reach = std::max({reach, aside, std::abs(point.y) * std::cos(tilt) + aside * std::sin(tilt)});
    }
  }
  return reach;
}

}  // namespace

MenuPage levelsPage(std::span<const LevelEntry> levels, const std::function<void(std::size_t)>& choose) {
  MenuPage page{"Levels"};
  page.place = MenuPage::Place::kLeft;
  for (const auto& [heading, i] : rowsOf(levels)) {
    if (!heading.empty()) {
      page.items.push_back({MenuItem::Kind::kHeading, heading});
    } else {
      page.items.push_back(itemOf(levels[i]));
      page.items.back().choose = [choose, i = i] { choose(i); };
    }
  }
  return page;
}

std::size_t itemOfLevel(std::span<const LevelEntry> levels, std::size_t level) {
  const std::vector<Row> rows = rowsOf(levels);
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [level](const Row& row) { return row.heading.empty() && row.level == level; });
  return static_cast<std::size_t>(found - rows.begin());
}

std::size_t levelOfItem(std::span<const LevelEntry> levels, std::size_t item) {
  const std::vector<Row> rows = rowsOf(levels);
  return rows[std::min(item, rows.size() - 1)].level;
}

void Turntable::show(Scene scene, double seconds) {
  const bool isNew = scene_.stage != scene.stage;
  scene_ = std::move(scene);
  const glm::dvec3 front = scene_.focus.normal;
  const double angle = std::remainder(std::atan2(front.z, front.x) - kLead - angle_, 2 * std::numbers::pi);
  const double height = std::max(kHeight + (front.y > 0 ? kHeightUp : kHeightDown) * front.y, -kMostBelow) - height_;
  const double rate = kFollow * std::max(0.1, std::hypot(front.x, front.z));  // top and bottom have no direction
  const auto part = [&](double way, double perSecond) {
    return isNew ? way : way - std::copysign(leftAfter(std::abs(way), perSecond, kMaxFollow, seconds), way);
  };
  angle_ += part(angle, rate);
  height_ += part(height, kFollow);
}

Camera Turntable::camera(std::uint32_t w, std::uint32_t h) const {
  Camera camera;
  camera.resize(w, h);
  const glm::dvec3 direction(std::cos(angle_), height_, std::sin(angle_));
  const SolidMesh& mesh = scene_.stage->mesh;
  const double aspect = double{1} * camera.width() / camera.height();
  const bool beside = aspect > kWide;
  const double size = beside ? std::min(kSize, kSizeOfWidth * aspect) : kSizeAlone;
  const double distance = reachOf(mesh) * std::hypot(1, 1 / (CameraTarget::kTangent * size));
  camera.place(glm::normalize(direction) * distance, {0, 1, 0}, mesh);
  if (beside) camera.setShift({kShift, kAbove});
  return camera;
}

void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width, float scale) {
  if (width <= Turntable::kWide * Overlay::kHeight) return;
  const glm::vec2 screen = glm::vec2(width, Overlay::kHeight) / scale;
  const float middle = screen.x * static_cast<float>(Turntable::kMiddle);
  const float room = std::min(middle - endOfLeftColumn(screen), screen.x - middle) - kMargin;
  if (room < kLeast) return;
  OverlayWriter writer(font);
  const std::string players = counted(level.players, "player");
  writer.centred(fittedText(level.title, font, 2 * room / 24), {middle, screen.y - kTitle}, 24, kBright);
  const float baseline = kSmallestText * Font::kCapitalHeight / 2;
  writer.pill(level.solid + " · " + players, {middle, screen.y - kFacts - baseline}, kSmallestText, kSoft);
  if (level.medals) addMedals(writer, *level.medals, {middle, screen.y - kMedals}, room);
  const Overlay card = scaledBy(writer.take(), scale);
  overlay.panels.insert(overlay.panels.end(), card.panels.begin(), card.panels.end());
  overlay.texts.insert(overlay.texts.end(), card.texts.begin(), card.texts.end());
}

}  // namespace platon
