#include "server/admin/enforce_bans.h"

#include "server/admin/origin_address.h"

namespace platon {

std::size_t enforceBans(Match& match, const BanList& bans, UtcTime now) {
  std::size_t removed = 0;
  for (const PlayerStatus& player : match.playerStatus()) {
    const auto address = addressOfOrigin(player.origin);
    const Ban* ban = address ? bans.find(*address, now) : nullptr;
    if (ban && match.kick(player.slot, refusalOf(*ban))) ++removed;
  }
  return removed;
}

}  // namespace platon
