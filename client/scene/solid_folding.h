#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include "client/scene/solid_mesh.h"
#include "client/scene/view_point.h"

namespace platon {

/// Transforms from the frames of the faces to space when the unfolded solid is folded by `part`: 0, it lies in the
/// plane of the face `root`; 1, it is the solid, and each is exactly SolidFrame::faceToWorld. Between, all hinges have
/// the same angle, and the root is where it is in the solid.
std::vector<glm::dmat4> foldedPlaces(const SolidMesh& mesh, int root, double part);

/// The unfolding in the plane of the face of `root`, seen from outside.
struct UnfoldingView {
  ViewPoint view;    ///< shows the whole unfolding; the up of `root` is upwards
  double reach = 0;  ///< largest distance of a corner from the centre of the solid, level units
};

/// `aspect` is the width of the picture by its height, more than 0.
UnfoldingView viewOfUnfolding(const SolidMesh& mesh, const Pose& root, double aspect);

}  // namespace platon
