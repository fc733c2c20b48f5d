#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "platon/game/element.h"

namespace platon {

/// A place on a face: level units in the frame of the face.
struct FacePlace {
  int face = 0;
  glm::dvec2 place{0};

  friend bool operator==(const FacePlace&, const FacePlace&) = default;
};

/// The word of a segment with its numbers. Without a kind, it is a plain segment.
struct SegmentWord {
  std::optional<ElementKind> kind;
  std::array<int, 2> numbers{};  ///< as many count as numbersOf(kind) says

  /// How many numbers count.
  std::size_t count() const { return kind ? numbersOf(*kind) : 0; }

  /// Whether the number is that of an edge of the face.
  bool namesEdge() const { return kind && traitsOf(*kind).number == ElementNumber::kEdge; }

  friend bool operator==(const SegmentWord& a, const SegmentWord& b) {
    return a.kind == b.kind &&
           std::equal(a.numbers.begin(), a.numbers.begin() + static_cast<std::ptrdiff_t>(a.count()), b.numbers.begin());
  }
};

/// A segment as it is written: level units in the frame of its face, before it is cut at the edges.
struct EditedSegment {
  int face = 0;
  glm::dvec2 a{0};
  glm::dvec2 b{0};
  SegmentWord word;

  friend bool operator==(const EditedSegment&, const EditedSegment&) = default;
};

}  // namespace platon
