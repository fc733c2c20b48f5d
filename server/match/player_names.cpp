#include "server/match/player_names.h"

#include <utility>

#include "platon/game/utf8.h"
#include "protocol/label.h"
#include "protocol/to_client.h"

namespace platon {
namespace {

std::string slotName(std::uint32_t slot) { return "Player " + std::to_string(slot + 1); }

// Shortens the name, by whole characters, until the suffix fits.
std::string withSuffix(std::string_view name, const std::string& suffix) {
  std::size_t length = 0;
  while (length < name.size()) {
    const auto character = decodeUtf8(name.substr(length));
    const std::size_t next = length + (character ? character->length : 1);
    if (next + suffix.size() > kMaxNameBytes) break;
    length = next;
  }
  return visibleLabel(name.substr(0, length)) + suffix;
}

// As few messages as possible.
std::vector<SharedBytes> rostersOf(const std::vector<RosterEntry>& entries) {
  std::vector<SharedBytes> messages;
  Roster roster;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    roster.entries.push_back(entries[i]);
    if (i + 1 < entries.size() && roster.entries.size() < kMaxRosterEntries) continue;
    messages.emplace_back(encode(roster));
    roster.entries.clear();
  }
  return messages;
}

}  // namespace

const std::string& PlayerNames::claim(std::uint32_t slot, std::string_view wanted) {
  const std::string visible = visibleLabel(wanted);
  names_[slot] = reserve(visible.empty() ? slotName(slot) : visible);
  noteChange(slot);
  return names_[slot];
}

const std::string& PlayerNames::rename(std::uint32_t slot, std::string_view wanted) {
  const bool muted = isMuted(slot);
  release(slot);
  claim(slot, wanted);
  mute(slot, muted);
  return names_[slot];
}

void PlayerNames::release(std::uint32_t slot) {
  mute(slot, false);
  taken_.erase(lookAlikeKey(names_[slot]));
  names_[slot].clear();
  noteChange(slot);
}

// The name stays reserved meanwhile, so that nobody else can take it. A name that is the number of the slot is shown as
// it is.
void PlayerNames::mute(std::uint32_t slot, bool muted) {
  if (muted == isMuted(slot)) return;
  if (!muted) {
    muted_.erase(slot);
    if (!numbers_[slot].empty()) taken_.erase(lookAlikeKey(std::exchange(numbers_[slot], {})));
  } else {
    muted_.insert(slot);
    if (lookAlikeKey(names_[slot]) != lookAlikeKey(slotName(slot))) numbers_[slot] = reserve(slotName(slot));
  }
  noteChange(slot);
}

// The name, or with a number if another one looks like it.
std::string PlayerNames::reserve(std::string_view base) {
  std::string name(base);
  for (int number = 2; !taken_.insert(lookAlikeKey(name)).second; ++number) {
    name = withSuffix(base, " " + std::to_string(number));
  }
  return name;
}

void PlayerNames::noteChange(std::uint32_t slot) {
  changed_.insert(slot);
  all_.reset();
}

const std::vector<SharedBytes>& PlayerNames::all() {
  if (all_) return *all_;
  std::vector<RosterEntry> entries;
  for (std::uint32_t slot = 0; slot < names_.size(); ++slot) {
    if (!isFree(slot)) entries.push_back({slot, shown(slot)});
  }
  return all_.emplace(rostersOf(entries));
}

std::vector<SharedBytes> PlayerNames::takeChanges() {
  std::vector<RosterEntry> entries;
  for (const std::uint32_t slot : std::exchange(changed_, {})) entries.push_back({slot, shown(slot)});
  return rostersOf(entries);
}

}  // namespace platon
