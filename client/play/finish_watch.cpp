#include "client/play/finish_watch.h"

#include <fmt/format.h>

namespace platon {

std::optional<std::string> FinishWatch::look(const Session& session) {
  const Round* const round = session.round();
  if (round == nullptr || !round->prediction().present()) return std::nullopt;
  const Game& game = round->prediction().confirmed();
  const PlayerState& player = game.player(round->prediction().slot());
  const std::pair finish(round->id(), player.finishedAt);
  if (player.finished == 0 || reported_ == finish) return std::nullopt;
  reported_ = finish;
  const std::string& title = game.level().title;
  return fmt::format("finished {} in {:.1f} s", title.empty() ? "the level" : title,
                     double{1} * player.finishedAt / kTicksPerSecond);
}

}  // namespace platon
