#include "client/menu/pages/level_card.h"

#include <algorithm>
#include <string>
#include <utility>

#include "client/menu/menu_layout.h"
#include "client/menu/pages/turntable.h"
#include "client/ui/fitted_text.h"
#include "client/ui/overlay_writer.h"
#include "client/ui/player_rows.h"
#include "client/ui/text_scale.h"

namespace platon {
namespace {

using namespace overlay_colours;

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

}  // namespace

void addLevelCard(Overlay& overlay, const LevelEntry& level, const Font& font, float width, float scale) {
  if (width <= Turntable::kWide * Overlay::kHeight) return;
  const glm::vec2 screen = glm::vec2(width, Overlay::kHeight) / scale;
  const float middle = screen.x * static_cast<float>(Turntable::kMiddle);
  const float room = std::min(middle - endOfLeftColumn(screen), screen.x - middle) - kMargin;
  if (room < kLeast) return;
  OverlayWriter writer(font);
  const std::string players = level.players == 1 ? "1 player" : std::to_string(level.players) + " players";
  writer.centred(fittedText(level.title, font, 2 * room / 24), {middle, screen.y - kTitle}, 24, kBright);
  const float baseline = kSmallestText * Font::kCapitalHeight / 2;
  writer.pill(level.solid + " · " + players, {middle, screen.y - kFacts - baseline}, kSmallestText, kSoft);
  if (level.medals) addMedals(writer, *level.medals, {middle, screen.y - kMedals}, room);
  const Overlay card = scaledBy(writer.take(), scale);
  overlay.panels.insert(overlay.panels.end(), card.panels.begin(), card.panels.end());
  overlay.texts.insert(overlay.texts.end(), card.texts.begin(), card.texts.end());
}

}  // namespace platon
