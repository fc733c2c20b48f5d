#include "client/gl/paint/face_program.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace platon {
namespace {

constexpr std::size_t kMaxEdges = 5;  // of a face

}  // namespace

float litOf(const FaceView& view) { return 0.77F + 0.30F * std::max(view.light.z, 0.0F); }

void useOnFace(ShaderProgram& program, const StageModel& stage, const FaceView& view) {
  std::vector<glm::vec2> normals(stage.mesh.edgeNormals().begin(), stage.mesh.edgeNormals().end());
  normals.resize(kMaxEdges, normals.back());
  program.use();
  program.set("toClip", view.toClip);
  program.set("edges", normals);
  program.set("apothem", static_cast<float>(stage.mesh.apothem()));
}

}  // namespace platon
