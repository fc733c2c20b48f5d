#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "platon/game/element.h"
#include "platon/game/player.h"
#include "platon/physics/entity_state.h"

namespace platon {

/// Kinds of elements: bit K is kElementKinds[K].
using ElementKindMask = std::uint32_t;
static_assert(kElementKinds.size() < 32, "a mask has a bit for each kind");

/// Kinds of elements that a player has not been told about yet.
struct UntoldElements {
  ElementKindMask mask = (ElementKindMask{1} << kElementKinds.size()) - 1;

  friend bool operator==(const UntoldElements&, const UntoldElements&) = default;
};

/// For the settings file: the words of the kinds with commas between, or "none".
std::string textOf(UntoldElements untold);
/// Reads what textOf writes. Another text changes nothing and returns false.
bool parse(std::string_view text, UntoldElements& untold);

/// Tells a new player what the elements of a level do, one kind at a time: the one that the ball meets, else each that
/// it has not met, once for a while.
class ElementHints {
 public:
  /// Notes a tick of the player in a level with these elements. `shown`: the hint was on the screen. A kind that the
  /// ball has met, and whose hint was shown long enough, leaves `untold`. A restart changes nothing.
  void observe(const PlayerState& player, const EntityState& ball, std::span<const Element> elements, bool shown,
               UntoldElements& untold);
  /// What the kind does that is told now; empty if there is none.
  std::string_view hint() const;
  /// Whether the ball has met an element of this kind, so that it is time for its hint.
  bool isDue() const { return kind_ != kNone && (met_ & ElementKindMask{1} << kind_) != 0; }

 private:
  void tell(std::uint8_t kind);
  // The next kind of `open`, which may be the present one; kNone if there is none.
  std::uint8_t nextOf(ElementKindMask open) const;

  std::uint8_t kind_ = kNone;  // index into kElementKinds
  ElementKindMask kinds_ = 0;  // of the level
  ElementKindMask told_ = 0;   // these have had their turn before the ball has met one
  ElementKindMask met_ = 0;    // the ball has been near an element of these
  std::uint32_t ticks_ = 0;    // for which the hint has been on the screen while the ball was played

  static constexpr std::uint8_t kNone = kElementKinds.size();
};

}  // namespace platon
