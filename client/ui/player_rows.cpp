#include "client/ui/player_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "client/netcode/player_snapshot.h"
#include "platon/game/utf8.h"

namespace platon {
namespace {

constexpr std::size_t kMaxNameLength = 20;  // code points shown of a name

// Cuts a name of more than kMaxNameLength code points and appends an ellipsis.
std::string shortened(const std::string& name) {
  std::string_view rest = name;
  for (std::size_t i = 0; i < kMaxNameLength && !rest.empty(); ++i) takeCodePoint(rest);
  return rest.empty() ? name : name.substr(0, name.size() - rest.size()) + "…";
}

}  // namespace

std::string calledName(const std::string& name, const std::string& number) {
  return name.empty() ? "Player " + number : name;
}

std::string shownNameOf(const PlayerDrawing& player) { return shortened(calledName(player.name, player.number)); }

std::string twoDigits(long value) { return (value < 10 ? "0" : "") + std::to_string(value); }

std::string finishText(double seconds) {
  const long hundredths = std::lround(seconds * 100);
  return std::to_string(hundredths / 100) + "." + twoDigits(hundredths % 100) + " s";
}

std::string finishTextOf(std::uint32_t ticks) { return finishText(secondsOf(ticks)); }

std::string roundTripText(const PlayerDrawing& player) {
  if (!player.roundTripMs) return {};
  return *player.roundTripMs > 1000 ? "over 1 s" : std::to_string(*player.roundTripMs) + " ms";
}

float roundTripWidth(const Scene& scene) {
  constexpr float kWidth = 72;
  const bool known = std::any_of(scene.players.begin(), scene.players.end(),
                                 [](const PlayerDrawing& player) { return player.roundTripMs.has_value(); });
  return known ? kWidth : 0;
}

std::vector<const PlayerDrawing*> inOrder(const Scene& scene) {
  std::vector<const PlayerDrawing*> players;
  for (const PlayerDrawing& player : scene.players) players.push_back(&player);
  std::sort(players.begin(), players.end(), [](const PlayerDrawing* a, const PlayerDrawing* b) {
    if (a->finishSeconds.has_value() != b->finishSeconds.has_value()) return a->finishSeconds.has_value();
    if (a->finishSeconds != b->finishSeconds) return a->finishSeconds < b->finishSeconds;
    return a->slot < b->slot;
  });
  return players;
}

}  // namespace platon
