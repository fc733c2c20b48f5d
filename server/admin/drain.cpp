#include "server/admin/drain.h"

#include <algorithm>

#include "protocol/limits.h"

namespace platon {
namespace {

// The longest sentence below has fewer bytes than this besides the address.
static_assert(kMaxNextServerBytes + 70 <= kMaxReasonBytes);

}  // namespace

void Drain::begin(TimePoint now, std::chrono::seconds limit, const std::string& next) {
  end_ = now + limit;
  const std::string where = next.empty() ? "" : " Go on at " + next + ".";
  const std::string refusal =
      "the server is about to stop; " + (next.empty() ? "join another one" : "go on at " + next);
  match_.drain("The server stops after this round." + where, {RefusalCode::kOther, refusal, next});
  match_.say("The server stops after this round, in " + std::to_string(limit.count()) + " s at most." + where);
}

std::optional<std::string_view> Drain::over(TimePoint now) const {
  if (!begun()) return std::nullopt;
  if (match_.idle()) return "no players";
  if (match_.drained()) return "round over";
  return now >= end_ ? std::optional<std::string_view>("time") : std::nullopt;
}

std::chrono::seconds Drain::secondsLeft(TimePoint now) const {
  return std::chrono::ceil<std::chrono::seconds>(std::max(end_ - now, TimePoint::duration::zero()));
}

}  // namespace platon
