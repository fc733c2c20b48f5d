#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "platon/exact/angle.h"
#include "platon/exact/point.h"
#include "platon/game/diagnostics.h"
#include "platon/game/solid.h"
#include "platon/physics/segment.h"
#include "platon/physics/world.h"

namespace platon {

/// A level as the game plays it; the file format is in docs/level_format.md. Immutable once loaded.
struct Level {
  SolidKind solid = SolidKind::kHexahedron;
  std::int32_t faceSize = 0;  ///< edge length, level units
  std::uint32_t startFace = 0;
  Point start;       ///< subunits, in the face's frame
  Angle startAngle;  ///< of the player's up from the face's +y
  std::uint32_t goalFace = 0;
  Point goal;
  std::vector<std::vector<Segment>> lines;  ///< per face, cut at the edges, without posts
  std::string title;                        ///< at most 100 bytes of printable UTF-8, perhaps empty
  std::string author;                       ///< likewise
  std::string text;                         ///< the whole file
  std::uint64_t hash = 0;                   ///< of the text

  /// A world with every face as a map part (id = face index): lines, then posts, then one warp per edge (warp index =
  /// edge index). No entities.
  World world;
};

/// Longest level text, bytes.
inline constexpr std::size_t kMaxLevelBytes = std::size_t{4} << 20;

struct LevelResult {
  std::shared_ptr<const Level> level;   ///< null when there is any error
  std::vector<Diagnostic> diagnostics;  ///< all of them, in the order of the text
};

/// Reads a level. Every fault is reported; nothing is guessed.
LevelResult loadLevel(std::string_view text);

}  // namespace platon
