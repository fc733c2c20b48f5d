#pragma once

#include <array>
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
enum class ElementKind : std::uint8_t { kOneway, kUp, kHazard, kCheckpoint, kKey, kDoor, kPlate };

inline constexpr std::array<ElementKind, 7> kElementKinds = {
    ElementKind::kOneway, ElementKind::kUp,   ElementKind::kHazard, ElementKind::kCheckpoint,
    ElementKind::kKey,    ElementKind::kDoor, ElementKind::kPlate};

/// The word in level files: "oneway" …
std::string_view wordOf(ElementKind kind);
/// The kind with this word; nothing when there is none.
std::optional<ElementKind> elementKindOf(std::string_view word);
/// Whether a number follows the word.
constexpr bool hasNumber(ElementKind kind) {
  return kind == ElementKind::kUp || kind == ElementKind::kKey || kind == ElementKind::kDoor ||
         kind == ElementKind::kPlate;
}
/// Whether a segment of this kind can block a player. The others are only touched.
constexpr bool canBlock(ElementKind kind) { return kind != ElementKind::kCheckpoint && kind != ElementKind::kKey; }
/// Whether a segment of this kind blocks all players at any time.
constexpr bool blocksAlways(ElementKind kind) { return kind == ElementKind::kHazard || kind == ElementKind::kPlate; }

/// Numbers of keys, doors and plates are below this: a door is one bit of the game's state.
inline constexpr std::uint32_t kMaxDoorNumbers = 32;

/// A segment of a level with a word.
struct Element {
  ElementKind kind = ElementKind::kOneway;
  std::uint8_t number = 0;  ///< edge of the face (kUp), or number of keys, doors and plates that belong together
  std::uint32_t face = 0;
  std::uint32_t segment = 0;  ///< index into the segments of the face
  Segment ends;               ///< in the frame of the face

  /// The bit of `number`. Requires a key, a door or a plate.
  std::uint32_t bit() const { return std::uint32_t{1} << number; }

  friend bool operator==(const Element&, const Element&) = default;
};

/// The word of a segment and its number, as in level files: "key 1". Elements with the same belong together.
struct ElementWord {
  ElementKind kind = ElementKind::kOneway;
  std::uint8_t number = 0;  ///< 0 after a word without one

  bool isOf(const Element& element) const { return element.kind == kind && element.number == number; }
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
