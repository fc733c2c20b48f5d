#include "client/play/offscreen/local_game.h"

#include <utility>

#include "client/netcode/player_snapshot.h"

namespace platon {

LocalGame::LocalGame(std::shared_ptr<const Level> level, std::vector<std::string> names)
    : game_(std::move(level)), stage_(makeStageModel(game_.level())), names_(std::move(names)) {}

void LocalGame::begin() {
  game_ = Game(game_.sharedLevel());
  attempt_ = AttemptTime();
}

void LocalGame::advance(std::span<const Input> inputs) {
  game_.advance(inputs);
  attempt_.observe(game_.tick(), game_.player(0));
}

Scene LocalGame::scene(const BallChoice& ownBall) const {
  std::vector<PlayerSnapshot> players;
  for (std::uint32_t slot = 0; slot < game_.slots(); ++slot) players.push_back(snapshotOf(game_, slot));
  SceneSource source;
  source.stage = stage_;
  source.game = &game_;
  source.others = {players, players, 1};
  source.localSlot = 0;
  source.names = names_;
  source.attempt = attempt_;
  source.ownBalls = {{0, ownBall}};
  source.timed = names_.size() > 1;
  return makeScene(source);
}

}  // namespace platon
