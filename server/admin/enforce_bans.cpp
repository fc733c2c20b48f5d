#include "server/admin/enforce_bans.h"

namespace platon {

std::size_t enforceBans(Match& match, const BanList& bans, UtcTime now) {
  std::size_t removed = 0;
  for (const PlayerStatus& player : match.playerStatus()) {
    const Ban* ban = bans.find(player.address, now);
    if (ban && match.kick(player.slot, refusalOf(*ban))) ++removed;
  }
  return removed;
}

}  // namespace platon
