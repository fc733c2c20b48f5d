#include "server/match/player_names.h"

#include "platon/game/utf8.h"
#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

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

}  // namespace

std::string PlayerNames::claim(std::string_view wanted, std::string_view substitute) {
  const std::string visible = visibleLabel(wanted);
  const std::string base = visible.empty() ? std::string(substitute) : visible;
  std::string name = base;
  for (int number = 2; !taken_.insert(lookAlikeKey(name)).second; ++number) {
    name = withSuffix(base, " " + std::to_string(number));
  }
  return name;
}

void PlayerNames::release(std::string_view name) { taken_.erase(lookAlikeKey(name)); }

}  // namespace platon
