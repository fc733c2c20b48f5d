#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "platon/game/element.h"

namespace platon {

/// The word of a segment with its number. Without a kind, it is a plain segment.
struct SegmentWord {
  std::optional<ElementKind> kind;
  int number = 0;  ///< counts only if hasNumber(kind)

  friend bool operator==(const SegmentWord& a, const SegmentWord& b) {
    return a.kind == b.kind && (!a.kind || !hasNumber(*a.kind) || a.number == b.number);
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
