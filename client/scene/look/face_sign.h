#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "client/scene/stage_model.h"

namespace platon {

/// A small sign by which players tell faces apart: a ring with a number of corners, and dots in it.
struct FaceSign {
  glm::vec2 place{0};  ///< level units in the frame of the face
  float radius = 1;    ///< level units
  int corners = 3;     ///< 3 … 7; the ring of 7 is drawn as a circle
  int dots = 1;        ///< 1 … 4
};

/// The signs of the faces, each one different. A sign lies in the middle or towards a corner: where it is farthest from
/// segments, start and goal.
std::vector<FaceSign> signsOf(const StageModel& stage);

}  // namespace platon
