#include "client/menu/pages/level_card.h"

#include <string>
#include <utility>

#include "client/menu/pages/turntable.h"
#include "client/ui/overlay_writer.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"

namespace platon {
namespace {

using namespace overlay_colours;

constexpr float kTitle = Overlay::kHeight - 98;  // baselines
constexpr float kFacts = Overlay::kHeight - 72;
constexpr float kMedals = Overlay::kHeight - 40;

std::string medalText(Medal medal, std::uint32_t ticks) {
  return starsOf(medal) + " " + finishText(double{1} * ticks / kTicksPerSecond);
}

void addMedals(OverlayWriter& writer, const MedalTimes& times, float middle) {
  const std::pair<Medal, std::uint32_t> medals[]{
      {Medal::kGold, times.gold}, {Medal::kSilver, times.silver}, {Medal::kBronze, times.bronze}};
  constexpr float kDistance = 132;
  const glm::vec2 half(1.5F * kDistance, 14);
  const glm::vec2 panel(middle, kMedals - 15 * Font::kCapitalHeight / 2);
  writer.panel(panel - half, panel + half, half.y, kPanel);
  float x = middle - kDistance;
  for (const auto& [medal, ticks] : medals) {
    writer.centred(medalText(medal, ticks), {x, kMedals}, 15, colourOf(medal));
    x += kDistance;
  }
}

}  // namespace

void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width) {
  if (width <= Turntable::kWide * Overlay::kHeight) return;
  OverlayWriter writer(font);
  const float middle = width * static_cast<float>(Turntable::kMiddle);
  const std::string players = level.players == 1 ? "1 player" : std::to_string(level.players) + " players";
  writer.centred(level.title, {middle, kTitle}, 24, kBright);
  writer.centred(level.solid + "   " + players, {middle, kFacts}, 15, kSoft);
  if (level.medals) addMedals(writer, *level.medals, middle);
  const Overlay card = writer.take();
  overlay.panels.insert(overlay.panels.end(), card.panels.begin(), card.panels.end());
  overlay.texts.insert(overlay.texts.end(), card.texts.begin(), card.texts.end());
}

}  // namespace platon
