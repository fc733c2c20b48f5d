#include "client/ui/hints/element_hints.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "platon/game/game.h"

namespace platon {
namespace {

// Of play: who only looks at the level reads on.
constexpr std::uint32_t kElementReadTicks = 4 * kTicksPerSecond;  // to read a hint of an element that the ball has met
constexpr std::uint32_t kTurnTicks = 8 * kTicksPerSecond;         // of a kind that the ball has not met
constexpr double kNearElement = 2.0 * kPlayerRadius;              // from the ball to an element that it meets, subunits

constexpr std::size_t indexOf(ElementKind kind) { return static_cast<std::size_t>(kind); }

ElementKindMask bit(std::size_t kind) { return ElementKindMask{1} << kind; }

// What opens the doors of a level with elements of these kinds.
std::string_view doorHint(ElementKindMask kinds) {
  const bool byKey = (kinds & bit(indexOf(ElementKind::kKey))) != 0;
  const bool byPlate = (kinds & bit(indexOf(ElementKind::kPlate))) != 0;
  if (byKey && byPlate)
    return "A door opens with the key of its number, or while somebody stands on the plate of its number";
  return byPlate ? "A door is open while somebody stands on the plate of its number"
                 : "A door opens with the key of its number";
}

// What a kind does, on a level with elements of these kinds.
std::string_view hintOf(ElementKind kind, ElementKindMask kinds) {
  switch (kind) {
    case ElementKind::kOneway:
      return "A ledge with arrows lets you pass the way they point";
    case ElementKind::kUp:
      return "A wall of arrows is solid while its arrows are filled, and they are while they point up for you";
    case ElementKind::kHazard:
      return "Red thorns send you back to the start, or to your last flag";
    case ElementKind::kCheckpoint:
      return "After you touch a flag, red thorns send you back to it";
    case ElementKind::kKey:
      return "A key opens all doors with its number";
    case ElementKind::kDoor:
      return doorHint(kinds);
    case ElementKind::kPlate:
      return "While somebody stands on a plate, the doors with its number are open";
    case ElementKind::kTimed:
      return "A fence is solid until its clock is empty, and open until it is full again";
  }
  return {};
}

ElementKindMask kindsOf(std::span<const Element> elements) {
  ElementKindMask kinds = 0;
  for (const Element& element : elements) kinds |= bit(indexOf(element.kind));
  return kinds;
}

bool isNear(const EntityState& ball, const Element& element) {
  if (ball.part != element.face) return false;
  const auto inSubunits = [](Point point) { return glm::dvec2(point.x, point.y); };
  const glm::dvec2 way = inSubunits(element.ends.b) - inSubunits(element.ends.a);
  const glm::dvec2 place = inSubunits(ball.position) - inSubunits(element.ends.a);
  const double part = std::clamp(glm::dot(place, way) / std::max(glm::dot(way, way), 1.0), 0.0, 1.0);
  return glm::distance(place, part * way) < kNearElement;
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
  ElementKindMask mask = 0;
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

std::uint8_t ElementHints::nextOf(ElementKindMask open) const {
  for (std::size_t step = 1; step <= kNone + std::size_t{1}; ++step) {
    const std::size_t kind = (kind_ + step) % (kNone + std::size_t{1});
    if ((open & bit(kind)) != 0) return static_cast<std::uint8_t>(kind);
  }
  return kNone;
}

void ElementHints::tell(std::uint8_t kind) {
  kind_ = kind;
  ticks_ = 0;
}

void ElementHints::observe(const PlayerState& player, const EntityState& ball, std::span<const Element> elements,
                           bool shown, UntoldElements& untold) {
  kinds_ = kindsOf(elements);
  const ElementKindMask open = kinds_ & untold.mask;
  met_ &= open;
  if (kind_ != kNone && ticks_ >= kTurnTicks) told_ |= bit(kind_);
  if (kind_ == kNone || (open & bit(kind_)) == 0 || ticks_ >= kTurnTicks) tell(nextOf(open & ~told_));
  if (player.startedAt == 0 || player.arrived != 0) return;
  for (const Element& element : elements) {
    if (isNear(ball, element)) met_ |= bit(indexOf(element.kind)) & open;
  }
  if (!isDue() && met_ != 0) tell(nextOf(met_));
  if (kind_ == kNone || !shown || ++ticks_ < kElementReadTicks || !isDue()) return;
  untold.mask &= ~bit(kind_);
  met_ &= ~bit(kind_);
}

std::string_view ElementHints::hint() const {
  return kind_ == kNone ? std::string_view() : hintOf(kElementKinds[kind_], kinds_);
}

}  // namespace platon
