#include "server/match/match_talk.h"

#include "protocol/label.h"
#include "protocol/to_client.h"
#include "server/match/roster.h"

namespace platon {

// Who is muted is not heard. The speaker, too, gets its text from the server, and so sees what was not passed on.
void MatchTalk::say(ClientId id, MatchClient& client, const LocalChat& message, const MatchRoster& roster,
                    std::uint64_t now, MatchOutput& output) {
  MatchPlayer* const speaker = client.player(message.local);
  if (!enabled_ || speaker == nullptr) return;
  const Chat said{visibleLabel(message.chat.text), message.chat.emote};
  if (!isChat(said) || roster.names().isMuted(speaker->slot())) return;
  if (!speaker->mayChat(now) || !mayChat(client.address(), now)) return;
  roster.sendAll(encode(PlayerChat{speaker->slot(), said}), output);
  if (said.emote == 0) output.add(MatchEvent::Kind::kChat, id, speaker->slot(), said.text);
}

// An owner of many households, as every connection to the internet by IPv6 has them, must not send everybody texts
// without end. Household 0 has no limit of players, so it has none but the limit of a site.
bool MatchTalk::mayChat(const IpAddress& address, std::uint64_t now) {
  const bool isWithin = address.household() == 0 || households_.take(address.household(), now);
  return isWithin && sites_.take(address.site(), now);
}

}  // namespace platon
