#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "client/editor/edited_segment.h"
#include "client/editor/face_place.h"

namespace platon {

/// A segment near a pointer, and what of it.
struct PickedSegment {
  enum class Part { kWhole, kFirstEnd, kSecondEnd };

  std::size_t segment = 0;  ///< index into the segments
  Part part = Part::kWhole;

  friend bool operator==(const PickedSegment&, const PickedSegment&) = default;
};

/// The segment of the pointer's face that is nearest to the pointer, within `reach` level units; of equally near ones
/// the last. An outer third of a segment stands for its end.
std::optional<PickedSegment> pickSegment(std::span<const EditedSegment> segments, const FacePlace& pointer,
                                         double reach);

}  // namespace platon
