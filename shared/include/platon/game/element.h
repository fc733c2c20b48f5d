#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/physics/segment.h"

namespace platon {

/// What the word of a segment makes of it. docs/level_format.md describes each.
enum class ElementKind : std::uint8_t { kOneway, kUp, kHazard, kCheckpoint, kKey, kDoor, kPlate, kTimed };

inline constexpr std::array<ElementKind, 8> kElementKinds = {
    ElementKind::kOneway, ElementKind::kUp,   ElementKind::kHazard, ElementKind::kCheckpoint,
    ElementKind::kKey,    ElementKind::kDoor, ElementKind::kPlate,  ElementKind::kTimed};

/// What the numbers after a word count.
enum class ElementNumber : std::uint8_t {
  kNone,  ///< no number follows
  kEdge,  ///< edges of the face
  kDoor,  ///< doors, and what opens them
  kTicks  ///< two numbers: the ticks for which it is solid, and those for which it is open then
};

/// Whom a segment blocks.
enum class ElementBlocking : std::uint8_t {
  kNobody,    ///< it is only touched
  kSome,      ///< it depends on the player or on the state of the game
  kEverybody  ///< at any time
};

/// What a segment does to who touches it, apart from blocking.
enum class ElementEffect : std::uint8_t {
  kNone,
  kSendBack,    ///< the player returns to its last checkpoint, or to the start
  kCheckpoint,  ///< the player returns there from then on
  kOpen,        ///< opens the doors of its number while it is touched
  kUnlock       ///< opens them for the rest of the round
};

struct ElementTraits {
  std::string_view word;  ///< in level files
  ElementNumber number;
  ElementBlocking blocking;
  ElementEffect effect;
};

/// What the code outside of the rules needs to know of a kind.
constexpr ElementTraits traitsOf(ElementKind kind) {
  switch (kind) {
    case ElementKind::kOneway:
      return {"oneway", ElementNumber::kNone, ElementBlocking::kSome, ElementEffect::kNone};
    case ElementKind::kUp:
      return {"up", ElementNumber::kEdge, ElementBlocking::kSome, ElementEffect::kNone};
    case ElementKind::kHazard:
      return {"hazard", ElementNumber::kNone, ElementBlocking::kEverybody, ElementEffect::kSendBack};
    case ElementKind::kCheckpoint:
      return {"checkpoint", ElementNumber::kNone, ElementBlocking::kNobody, ElementEffect::kCheckpoint};
    case ElementKind::kKey:
      return {"key", ElementNumber::kDoor, ElementBlocking::kNobody, ElementEffect::kUnlock};
    case ElementKind::kDoor:
      return {"door", ElementNumber::kDoor, ElementBlocking::kSome, ElementEffect::kNone};
    case ElementKind::kPlate:
      return {"plate", ElementNumber::kDoor, ElementBlocking::kEverybody, ElementEffect::kOpen};
    case ElementKind::kTimed:
      return {"timed", ElementNumber::kTicks, ElementBlocking::kSome, ElementEffect::kNone};
  }
  return {};
}
static_assert(traitsOf(static_cast<ElementKind>(kElementKinds.size())).word.empty(), "kElementKinds lacks a kind");

/// The word in level files: "oneway" …
constexpr std::string_view wordOf(ElementKind kind) { return traitsOf(kind).word; }
/// The kind with this word; nothing when there is none.
std::optional<ElementKind> elementKindOf(std::string_view word);
/// How many numbers follow the word: 0, 1 or 2.
constexpr std::size_t numbersOf(ElementKind kind) {
  switch (traitsOf(kind).number) {
    case ElementNumber::kNone:
      return 0;
    case ElementNumber::kEdge:
    case ElementNumber::kDoor:
      return 1;
    case ElementNumber::kTicks:
      return 2;
  }
  return 0;
}
/// Whether a segment of this kind can block a player. The others are only touched.
constexpr bool canBlock(ElementKind kind) { return traitsOf(kind).blocking != ElementBlocking::kNobody; }
/// Whether a segment of this kind blocks all players at any time.
constexpr bool blocksAlways(ElementKind kind) { return traitsOf(kind).blocking == ElementBlocking::kEverybody; }
/// Whether it returns who touches it to the last checkpoint, or to the start.
constexpr bool sendsBack(ElementKind kind) { return traitsOf(kind).effect == ElementEffect::kSendBack; }
/// Whether it opens the doors of its number.
constexpr bool opensDoors(ElementKind kind) {
  return traitsOf(kind).effect == ElementEffect::kOpen || traitsOf(kind).effect == ElementEffect::kUnlock;
}
/// Whether it opens them for the rest of the round: it is taken.
constexpr bool unlocksDoors(ElementKind kind) { return traitsOf(kind).effect == ElementEffect::kUnlock; }
/// Whether who touches it returns there from then on.
constexpr bool isCheckpoint(ElementKind kind) { return traitsOf(kind).effect == ElementEffect::kCheckpoint; }
/// Whether it is a door of its number: something else opens it.
constexpr bool isDoor(ElementKind kind) { return traitsOf(kind).number == ElementNumber::kDoor && !opensDoors(kind); }

/// Numbers of keys, doors and plates are below this: a door is one bit of the game's state.
inline constexpr std::uint32_t kMaxDoorNumbers = 32;

/// A timed segment is solid and open for at most this many ticks each: a minute.
inline constexpr std::uint32_t kMaxTimedTicks = 3600;

/// A range of numbers, both ends included.
struct NumberRange {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};
/// The range of each number after the word; of a word without one, only 0. `edges` is the number of edges of a face.
constexpr NumberRange rangeOf(ElementKind kind, std::uint32_t edges) {
  switch (traitsOf(kind).number) {
    case ElementNumber::kNone:
      return {0, 0};
    case ElementNumber::kEdge:
      return {0, edges - 1};
    case ElementNumber::kDoor:
      return {0, kMaxDoorNumbers - 1};
    case ElementNumber::kTicks:
      return {1, kMaxTimedTicks};
  }
  return {0, 0};
}

/// How much less than its apothem, in subunits, the centre of a player that stands on a one-way segment may be away
/// from it. More than the offset of segments that meet, so that a player who runs onto one does not fall through.
inline constexpr std::int32_t kOnewaySlack = 64;

/// A segment of a level with a word.
struct Element {
  ElementKind kind = ElementKind::kOneway;
  /// Edge of the face (kUp), number of keys, doors and plates that belong together, or ticks for which it is solid.
  std::uint16_t number = 0;
  std::uint16_t openTicks = 0;  ///< of kTimed: for which it is open then; 0 of others
  std::uint32_t face = 0;
  std::uint32_t segment = 0;  ///< index into the segments of the face
  Segment ends;               ///< in the frame of the face

  /// The bit of `number`. Requires a key, a door or a plate.
  std::uint32_t bit() const { return std::uint32_t{1} << number; }

  friend bool operator==(const Element&, const Element&) = default;
};

/// Where a timed segment is in its turn.
struct TimedPhase {
  bool isOpen = false;
  std::uint32_t ticksLeft = 0;  ///< of this state, the present tick included; at least 1
  std::uint32_t ticks = 0;      ///< of the whole state
};
/// Of the tick that follows after `tick` ticks of a round: first it is solid. Its numbers are 1 … 3600, so that a turn
/// has 2 … 7200 ticks.
constexpr TimedPhase phaseOf(const Element& timed, std::uint32_t tick) {
  const std::uint32_t solid = timed.number;
  const std::uint32_t passed = tick % (solid + timed.openTicks);
  if (passed < solid) return {false, solid - passed, solid};
  return {true, solid + timed.openTicks - passed, timed.openTicks};
}

/// What is open in a tick of a game.
struct OpenElements {
  std::uint32_t doors = 0;  ///< bits of the numbers whose doors are open
  std::uint32_t tick = 0;   ///< of the round, before this one

  /// Whether this element, a door or a timed segment, is open; false of others.
  constexpr bool has(const Element& element) const {
    if (element.kind == ElementKind::kTimed) return phaseOf(element, tick).isOpen;
    return isDoor(element.kind) && (doors & element.bit()) != 0;
  }
};

/// The word of a segment and its numbers, as in level files: "key 1". Elements with the same belong together.
struct ElementWord {
  ElementKind kind = ElementKind::kOneway;
  std::uint16_t number = 0;     ///< 0 after a word without one
  std::uint16_t openTicks = 0;  ///< the second number; 0 if there is none

  bool isOf(const Element& element) const {
    return element.kind == kind && element.number == number && element.openTicks == openTicks;
  }
  std::string text() const;

  friend bool operator==(const ElementWord&, const ElementWord&) = default;
};

/// Whether the element has one of the words.
bool isAmong(std::span<const ElementWord> words, const Element& element);

/// Reads what a way to the goal may need: "key K" or "plate K" with K below kMaxDoorNumbers, or "checkpoint". Nothing
/// for any other text. Spaces and tabs separate the words.
std::optional<ElementWord> needOf(std::string_view text);

/// What the players have touched in a tick.
struct TouchedElements {
  std::uint32_t keys = 0;               ///< bits of the keys
  std::uint32_t plates = 0;             ///< bits of the plates on which a player stands
  std::vector<std::uint32_t> atHazard;  ///< slots of the players that have touched a hazard, in rising order
};

/// The element of a segment, or null. `elements` are in order of face and segment.
const Element* findElement(std::span<const Element> elements, std::uint32_t face, std::uint32_t segment);

/// Whether `up`, an angle from the +y of a face, points to the edge of the face that an element of kind kUp names.
/// Every up points to one edge; half way between two, to the one that is counter-clockwise of it.
bool pointsTo(Angle up, const Element& element, std::int32_t edgesPerFace);

/// The point of a checkpoint at which players return: its middle, to the nearest subunit.
Point placeOf(const Element& checkpoint);

}  // namespace platon
