#include <array>

#include "tests/net/attacks/attack.h"
#include "tests/net/attacks/blind_attacks.h"
#include "tests/net/attacks/player_attacks.h"
#include "tests/net/attacks/session_attacks.h"
#include "tests/net/attacks/wire_attacks.h"

namespace platon {
namespace {

const std::array kAttacks{
    Attack{"empty", "empty datagrams, also in the victims' names", false, "malformed", floodEmpty},
    Attack{"oversized", "datagrams of 1 201 to 1 472 bytes", false, "malformed", floodOversized},
    Attack{"random", "random bytes", false, "seal", floodRandom},
    Attack{"knocks", "half-open handshakes from 10 000 addresses", false, "", floodKnocks},
    Attack{"victim-knocks", "half-open handshakes in the victims' names", false, "", floodVictimKnocks},
    Attack{"versions", "knocks of other protocol versions", false, "version", floodVersions},
    Attack{"bad-cookies", "opens with cookies that are invented", false, "cookie", floodBadCookies},
    Attack{"queries", "queries from 10 000 addresses", false, "queries", floodQueries},
    Attack{"forged", "sealed datagrams with invented contents in the victims' names", false, "seal", floodForged},
    Attack{"unsealed", "contents of ENet without a seal, disconnects too, in the victims' names", false, "seal",
           floodUnsealed},
    Attack{"replayed", "recorded datagrams of the victims, in any order", false, "seal", floodReplayed},
    Attack{"reopened", "recorded handshakes of the victims, from their addresses and others", false, "cookie",
           floodReplayedOpens},
    Attack{"moved", "recorded datagrams of the victims from other addresses", false, "seal", floodMoved},
    Attack{"raced", "the victims' datagrams from other addresses, before they come from their own", false, "seal",
           race},
    Attack{"flipped", "recorded datagrams with one bit flipped", false, "seal", floodFlipped},
    Attack{"truncated", "recorded datagrams without their end", false, "seal", floodTruncated},
    Attack{"reflected", "datagrams of the server sent back to it, also in its own name", false, "seal", floodReflected},
    Attack{"passwords", "opens with valid cookies and wrong keys or passwords", true, "password", guessPasswords},
    Attack{"handshakes", "sessions that are opened and never used", true, "unconfirmed", openSessions},
    Attack{"contents", "sessions with contents that no client sends", true, "content", sendHostileContents},
    Attack{"excess", "sessions that send far more than their budget", true, "excess", sendExcess},
    Attack{"roaming", "sessions that send in the names of 10 000 addresses", true, "excess", roam},
    Attack{"deaf", "players who acknowledge nothing", true, "", acknowledgeNothing},
    Attack{"false-acks", "players who acknowledge what was never sent, and nothing else", true, "slow",
           acknowledgeFalsely, IpVersion::kIpv4, true},
    Attack{"half-roamed", "the same, who send in other names and do not answer there", true, "slow", roamHalf,
           IpVersion::kIpv4, true},
    Attack{"future-acks", "players who acknowledge what was sent with a time in the future, and nothing else", true,
           "slow", acknowledgeInFuture, IpVersion::kIpv4, true},
    Attack{"roaming-places", "players, half again as many as may play, who roam and resume between four households",
           true, "full", roamForPlaces},
    Attack{"far-inputs", "players with inputs for ticks far away", true, "", sendFarInputs},
    Attack{"wrong-hashes", "players in permanent desync", true, "", sendWrongHashes},
    Attack{"requests", "players who request levels without end", true, "", requestLevels},
    Attack{"votes", "players, fewer than half, who vote and take it back without end", true, "", castVotes},
    Attack{"chat", "players who say the longest texts without end", true, "", talkWithoutEnd},
    Attack{"companions", "players whose companions join, leave, press and change their names without end", true, "",
           changeCompanions},
    Attack{"malformed", "players who send malformed messages and rejoin", true, "handshakes", sendMalformed},
    Attack{"tokens", "players who guess tokens", true, "handshakes", guessTokens},
    Attack{"join-leave", "64 clients who join and leave as often as they can", true, "handshakes", joinAndLeave},
    Attack{"join-drop", "64 clients who join and vanish as often as they can", true, "handshakes", joinAndVanish},
    Attack{"knocks-ipv6", "half-open handshakes over IPv6 from 10 000 addresses in 40 households", false, "",
           floodKnocks, IpVersion::kIpv6},
    Attack{"contents-ipv6", "sessions over IPv6 with contents that no client sends, from new addresses of 4 households",
           true, "content", sendHostileContents, IpVersion::kIpv6},
    Attack{"roaming-ipv6", "sessions over IPv6 that send in the names of 10 000 addresses in 40 households", true,
           "excess", roam, IpVersion::kIpv6},
    Attack{"join-leave-ipv6", "64 clients who join over IPv6 from 64 addresses of 4 households and leave", true,
           "handshakes", joinAndLeave, IpVersion::kIpv6},
};

}  // namespace

std::span<const Attack> attacks() { return kAttacks; }

}  // namespace platon
