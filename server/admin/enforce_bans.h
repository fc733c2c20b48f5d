#pragma once

#include <cstddef>

#include "server/admin/ban_list.h"
#include "server/base/utc_time.h"
#include "server/match/match.h"

namespace platon {

/// Removes all players of a match whose address is banned, connected or not, and tells them why. The address is the one
/// that their last message came from. Returns their number.
std::size_t enforceBans(Match& match, const BanList& bans, UtcTime now);

}  // namespace platon
