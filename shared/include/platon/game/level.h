#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/integer.h"
#include "platon/exact/point.h"
#include "platon/game/diagnostics.h"
#include "platon/game/element.h"
#include "platon/game/solid.h"
#include "platon/physics/segment.h"
#include "platon/physics/unfold.h"
#include "platon/physics/world.h"

namespace platon {

/// A loaded level. docs/level_format.md describes the file format. Immutable once loaded.
struct Level {
  SolidKind solid = SolidKind::kHexahedron;
  std::int32_t faceSize = 0;  ///< edge length, level units
  std::uint32_t startFace = 0;
  Point start;       ///< subunits, in the face's frame
  Angle startAngle;  ///< from the face's +y to the player's up, counter-clockwise
  std::uint32_t goalFace = 0;
  Point goal;                                  ///< subunits, in the face's frame
  std::vector<Place> goalPlaces;               ///< the goal in the frame of each face from which it can be touched
  std::vector<std::vector<Segment>> segments;  ///< per face, clipped at the edges, without posts; elements first
  std::vector<std::vector<TextPosition>> positions;  ///< of the segments in the text
  TextPosition startAt;                              ///< position of the start's x in the text
  TextPosition goalAt;                               ///< position of the goal's x in the text
  std::vector<Element> elements;                     ///< the segments with a word, in order of face and segment
  std::uint32_t doorNumbers = 0;                     ///< bits of the numbers of all keys and plates
  bool isTimed = false;                              ///< it has timed segments, so it depends on the clock of the round
  std::uint32_t players = 1;                         ///< how many players the level needs, as its text states
  std::optional<std::uint32_t> crossings;  ///< how many crossings every way to the goal needs, as its text states
  std::vector<ElementWord> needs;          ///< what every way to the goal uses, each of them, as its text states
  TextPosition needsAt;                    ///< where the text states them
  std::string title;                       ///< at most 100 bytes of printable UTF-8, may be empty
  std::string author;                      ///< at most 100 bytes of printable UTF-8, may be empty
  std::string text;                        ///< content of the level file
  std::uint64_t hash = 0;                  ///< hash of `text`

  /// The stage: see buildStage. Without entities.
  World world;
};

/// Radius of the goal's disc, subunits. A player has finished when its ball overlaps the disc.
inline constexpr std::int32_t kGoalRadius = 16 * kSubunitsPerUnit;

/// Most segments that may be within a tick's reach of a player, over the edges too. They bound what a player costs.
inline constexpr std::size_t kMaxSegmentsInReach = 512;
/// Largest sum of the lengths of all segments, level units: the width or the height of each, whichever is larger.
inline constexpr std::int64_t kMaxTotalUnits = std::int64_t{1} << 26;
/// Longest level text in bytes.
inline constexpr std::size_t kMaxLevelBytes = std::size_t{4} << 20;

struct LevelResult {
  std::shared_ptr<const Level> level;   ///< null when there is any error
  std::vector<Diagnostic> diagnostics;  ///< in the order of the text
};

/// Reads a level text and reports every error and warning.
LevelResult loadLevel(std::string_view text);

/// Bound of the segments that are within a tick's reach of a player, wherever on the level it is: 0 …
/// kMaxSegmentsInReach. It tells what a player can cost. Takes time in proportion to the segments and to the area of
/// the faces.
std::size_t segmentsInReach(const Level& level);

}  // namespace platon
