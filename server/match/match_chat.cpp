// What players say to each other.
#include "protocol/label.h"
#include "server/match/match.h"

namespace platon {

// An owner of many households, as every connection to the internet by IPv6 has them, must not send everybody texts
// without end. Origin 0 has no limit of players, so it has none but the limit of a site.
bool Match::mayChat(const IpAddress& address) {
  const bool isWithin = address.household() == 0 || householdChat_.take(address.household(), now_);
  return isWithin && siteChat_.take(address.site(), now_);
}

// Who is muted is not heard. The speaker, too, gets its text from the server, and so sees what was not passed on.
void Match::handle(ClientId client, const Chat& chat) {
  const auto found = players_.find(client);
  if (found == players_.end() || !settings_.chat) return;
  MatchPlayer& player = found->second;
  const Chat said{visibleLabel(chat.text), chat.emote};
  if (!isChat(said) || names_.isMuted(player.slot())) return;
  if (!player.mayChat(now_) || !mayChat(player.address())) return;
  sendAll(encode(PlayerChat{player.slot(), said}));
  if (said.emote == 0) addEvent(MatchEvent::Kind::kChat, client, player.slot(), said.text);
}

}  // namespace platon
