#include "client/ui/spectator.h"

#include <algorithm>
#include <utility>

#include "client/ui/player_rows.h"

namespace platon {

void Spectator::direct(Scene& scene, const KeyHints& keys) {
  const bool asked = std::exchange(asked_, false);
  hint_.clear();
  const bool others = std::any_of(scene.players.begin(), scene.players.end(),
                                  [](const PlayerDrawing& player) { return !player.local; });
  if (!scene.attempt || !scene.attempt->arrived || !others) return watched_.reset();
  if (asked) watchNext(scene);
  const auto watched = std::find_if(scene.players.begin(), scene.players.end(),
                                    [this](const PlayerDrawing& player) { return player.slot == watched_; });
  hint_ = keys.to(Control::kWatch, "watch another player");
  if (!watched_ || watched == scene.players.end()) return watched_.reset();
  scene.focus = watched->pose;
  hint_ = "watching " + shownNameOf(*watched) + " · " + keys.to(Control::kWatch, "next");
}

void Spectator::watchNext(const Scene& scene) {
  const auto follows = [this](const PlayerDrawing& player) {
    return !player.local && (!watched_ || player.slot > *watched_);
  };
  const auto found = std::find_if(scene.players.begin(), scene.players.end(), follows);
  watched_ = found == scene.players.end() ? std::nullopt : std::optional(found->slot);
}

}  // namespace platon
