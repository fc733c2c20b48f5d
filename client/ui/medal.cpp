#include "client/ui/medal.h"

#include <array>

#include "client/ui/overlay.h"
#include "client/ui/player_rows.h"
#include "platon/game/game.h"

namespace platon {
namespace {

constexpr std::uint32_t kStep = kTicksPerSecond / 10;
constexpr std::array<const char*, 4> kStars{"☆☆☆", "★☆☆", "★★☆", "★★★"};
constexpr std::array<const char*, 4> kMedalNames{"", "bronze", "silver", "gold"};
constexpr std::array<glm::vec4, 4> kMedalColours{overlay_colours::kSoft, glm::vec4(0.90F, 0.62F, 0.42F, 1),
                                                 glm::vec4(0.84F, 0.89F, 0.95F, 1), overlay_colours::kGold};

std::uint32_t scaled(std::uint32_t ticks, std::uint32_t percent) {
  const std::uint64_t whole = std::uint64_t{kStep} * 100;
  return static_cast<std::uint32_t>((std::uint64_t{ticks} * percent + whole - 1) / whole * kStep);
}

std::string nameOf(Medal medal) { return kMedalNames[static_cast<std::size_t>(medal)]; }

std::string withTime(Medal medal, std::uint32_t ticks) { return nameOf(medal) + ": " + finishTextOf(ticks); }

}  // namespace

MedalTimes medalTimesOf(std::uint32_t wayTicks) {
  return {scaled(wayTicks, 115), scaled(wayTicks, 150), scaled(wayTicks, 250)};
}

Medal medalFor(const MedalTimes& times, std::uint32_t ticks) {
  if (ticks <= times.gold) return Medal::kGold;
  if (ticks <= times.silver) return Medal::kSilver;
  return ticks <= times.bronze ? Medal::kBronze : Medal::kNone;
}

std::string starsOf(std::optional<Medal> medal) { return medal ? kStars[static_cast<std::size_t>(*medal)] : "★"; }

glm::vec4 colourOf(Medal medal) { return kMedalColours[static_cast<std::size_t>(medal)]; }

std::string medalText(const MedalTimes& times, std::uint32_t ticks) {
  const Medal medal = medalFor(times, ticks);
  if (medal == Medal::kNone) return nextMedalText(times, ticks);
  const std::string own = starsOf(medal) + " " + nameOf(medal);
  return medal == Medal::kGold ? own : own + ", " + nextMedalText(times, ticks);
}

std::string nextMedalText(const MedalTimes& times, std::optional<std::uint32_t> best) {
  switch (best ? medalFor(times, *best) : Medal::kNone) {
    case Medal::kGold:
      return nameOf(Medal::kGold);
    case Medal::kSilver:
      return withTime(Medal::kGold, times.gold);
    case Medal::kBronze:
      return withTime(Medal::kSilver, times.silver);
    default:
      return withTime(Medal::kBronze, times.bronze);
  }
}

}  // namespace platon
