#include "client/ui/hints/element_hints.h"

#include <algorithm>
#include <array>

#include "platon/game/game.h"

namespace platon {
namespace {

constexpr std::uint32_t kReadTicks = 8 * kTicksPerSecond;  // of play: who only looks at the level reads on

// In the order of kElementKinds. A level with doors has keys or plates, which tell of them.
constexpr std::array<std::string_view, kElementKinds.size()> kHints = {
    "A ledge with arrows lets you pass the way they point",
    "A block with an arrow is solid only while its arrow points up on the screen",
    "A zigzag sends you back to the start, or to your last flag",
    "Touch a flag, and a zigzag sends you back only to there",
    "A key opens all doors with its number",
    "",
    "The doors with the number of a plate are open while somebody stands on it",
};

std::uint8_t bit(std::size_t kind) { return static_cast<std::uint8_t>(1U << kind); }

std::uint8_t kindsOf(std::span<const Element> elements) {
  std::uint8_t kinds = 0;
  for (const Element& element : elements) kinds |= bit(static_cast<std::size_t>(element.kind));
  return kinds;
}

}  // namespace

std::string textOf(UntoldElements untold) {
  std::string text;
  for (std::size_t kind = 0; kind < kElementKinds.size(); ++kind) {
    if ((untold.mask & bit(kind)) != 0) text += (text.empty() ? "" : ",") + std::string(wordOf(kElementKinds[kind]));
  }
  return text.empty() ? "none" : text;
}

bool parse(std::string_view text, UntoldElements& untold) {
  if (text.empty()) return false;
  std::uint8_t mask = 0;
  for (std::string_view rest = text == "none" ? "" : text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(','), rest.size());
    const std::optional<ElementKind> kind = elementKindOf(rest.substr(0, end));
    if (!kind || end + 1 == rest.size()) return false;
    mask |= bit(static_cast<std::size_t>(*kind));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  untold.mask = mask;
  return true;
}

void ElementHints::observe(const PlayerState& player, std::span<const Element> elements, UntoldElements& untold) {
  const std::uint8_t open = kindsOf(elements) & untold.mask;
  std::uint8_t kind = 0;
  while (kind < kNone && ((open & bit(kind)) == 0 || kHints[kind].empty())) ++kind;
  if (kind != kind_) ticks_ = 0;
  kind_ = kind;
  if (kind_ == kNone || player.startedAt == 0 || player.arrived != 0) return;
  if (++ticks_ >= kReadTicks) untold.mask &= static_cast<std::uint8_t>(~bit(kind_));
}

std::string_view ElementHints::hint() const { return kind_ == kNone ? std::string_view() : kHints[kind_]; }

}  // namespace platon
