#include <algorithm>

#include "server/admin/bans.h"
#include "tests/fuzz/error_faults.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

const UtcTime kNow = UtcTime(std::chrono::hours(500'000));

// A ban that holds is found, except for loopback, and the one found lasts at least as long.
std::string findFault(const BanList& list) {
  for (const Ban& ban : list.bans()) {
    const Ban* found = list.find(ban.range.first(), kNow);
    if (ban.holds(kNow) && !found && !ban.range.first().isLoopback()) return "a ban that holds is not found";
    if (found && (!found->holds(kNow) || !found->range.contains(ban.range.first()))) return "a wrong ban is found";
    if (found && found->until && (!ban.until || *ban.until > *found->until)) return "a shorter ban is found";
    if (!list.find(ban.range) || *list.find(ban.range) != ban) return "a ban is not found by its range";
  }
  return {};
}

bool isReadAgain(const BanList& list) {
  const auto again = BanList::parse(list.text());
  return std::holds_alternative<BanList>(again) && std::get<BanList>(again) == list;
}

std::string changeFault(BanList list) {
  const std::vector<Ban> before = list.bans();
  const AddressRange range(*IpAddress::parse("192.0.2.7"));
  list.add({range, kNow, "added"});
  if (!isReadAgain(list)) return "a changed list is not read again";
  list.removeEnded(kNow);
  if (list.find(range) || !isReadAgain(list)) return "a ban that has ended is kept, or the list is broken";
  for (const Ban& ban : before) {
    const bool expected = ban.holds(kNow) && ban.range != range;
    if (list.remove(ban.range) != expected || !isReadAgain(list)) return "removing a ban has gone wrong";
  }
  return list.size() == 0 ? std::string() : "an emptied list has bans";
}

}  // namespace

std::string banListFault(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const auto parsed = BanList::parse(text);
  if (const auto* errors = std::get_if<std::vector<Diagnostic>>(&parsed))
    return errorsFault(*errors, BanList::kMaxErrors, text);
  const auto& list = std::get<BanList>(parsed);
  if (list.text() != text) return "the list has another text";
  if (std::string fault = findFault(list); !fault.empty()) return fault;
  return list.size() <= 32 ? changeFault(list) : std::string();
}

}  // namespace platon::fuzz
