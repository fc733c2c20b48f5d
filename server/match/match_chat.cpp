// What players say to each other.
#include "protocol/label.h"
#include "server/match/match.h"

namespace platon {

// Who is muted is not heard. The speaker, too, gets its text from the server, and so sees what was not passed on.
void Match::handle(ClientId client, const Chat& chat) {
  const auto found = players_.find(client);
  if (found == players_.end() || !settings_.chat) return;
  MatchPlayer& player = found->second;
  const Chat said{visibleLabel(chat.text), chat.emote};
  if (!isChat(said) || names_.isMuted(player.slot())) return;
  if (!player.mayChat(now_) || !householdChat_.take(player.origin(), now_)) return;
  sendAll(encode(PlayerChat{player.slot(), said}));
  if (said.emote == 0) addEvent(MatchEvent::Kind::kChat, client, player.slot(), said.text);
}

}  // namespace platon
