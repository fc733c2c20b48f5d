#include "client/gl/paint/light_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/draw_calls.h"
#include "client/gl/paint/face_program.h"
#include "client/scene/look/face_light.h"
#include "client/scene/look/wall.h"

namespace platon {
namespace {

constexpr float kTexel = 1.5F;  // wanted size of a texel, level units
constexpr GLsizei kMinSize = 128;
constexpr GLsizei kMaxSize = 1024;
constexpr float kSoft = 10;  // width of the occlusion beside a wall, level units

std::size_t ribbonsOf(const StageModel& stage) {
  std::size_t count = 0;
  for (const FaceDrawing& face : stage.faces) count += face.ribbons.size();
  return count;
}

// The size of a layer. Many faces or very many segments get coarser layers.
GLsizei sizeOf(const StageModel& stage, float reach) {
  const GLsizei limit = stage.mesh.faces() > 12 || ribbonsOf(stage) > 20000 ? kMaxSize / 2 : kMaxSize;
  return std::clamp(static_cast<GLsizei>(2 * reach / kTexel), kMinSize, limit);
}

float reachOf(const SolidMesh& mesh) {
  double reach = 0;
  for (const glm::dvec2 corner : mesh.polygon()) reach = std::max({reach, std::abs(corner.x), std::abs(corner.y)});
  return static_cast<float>(reach);
}

}  // namespace

LightMap::LightMap() : ground_("ground"), shade_("shade") {
  glBindVertexArray(array_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribDivisor(0, 1);
}

void LightMap::bake(const StageModel& stage, bool shadows) {
  allocate(stage);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, size_, size_);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendEquation(GL_MIN);
  for (int face = 0; face < stage.mesh.faces(); ++face) bakeFace(stage, face, shadows);
  glBlendEquation(GL_FUNC_ADD);
}

void LightMap::allocate(const StageModel& stage) {
  reach_ = reachOf(stage.mesh);
  size_ = sizeOf(stage, reach_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R8, size_, size_, stage.mesh.faces(), 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  for (const auto& [name, value] : {std::pair(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE),
                                    {GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE},
                                    {GL_TEXTURE_MAX_LEVEL, 0}})
    glTexParameteri(GL_TEXTURE_2D_ARRAY, static_cast<GLenum>(name), value);
}

// The layer begins white; each wall darkens it to what is not yet as dark, so that shadows do not add up.
void LightMap::bakeFace(const StageModel& stage, int face, bool shadows) {
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture_.name(), 0, face);
  glClearColor(1, 1, 1, 1);
  DrawCalls::clear(GL_COLOR_BUFFER_BIT);
  FaceView view;
  view.face = face;
  view.toClip = glm::ortho(-reach_, reach_, -reach_, reach_);
  useOnFace(ground_, stage, view);
  glBindVertexArray(array_.name());
  ground_.set("reach", reach_);
  DrawCalls::arrays(GL_TRIANGLE_STRIP, 4);
  const std::vector<Ribbon>& ribbons = stage.faces[static_cast<std::size_t>(face)].ribbons;
  if (ribbons.empty() || !shadows) return;
  const glm::dvec3 light = faceLight(stage.mesh, face);
  const glm::vec2 fall = glm::vec2(-light / light.z * Wall::kHeight);  // of the shadow of a top
  useOnFace(shade_, stage, view);
  shade_.set("fall", fall);
  shade_.set("halfWidth", static_cast<float>(StageModel::kRibbonWidth / 2));
  shade_.set("soft", std::max(kSoft, 3 * reach_ / static_cast<float>(size_)));
  glBindBuffer(GL_ARRAY_BUFFER, ends_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ribbons.size() * sizeof(Ribbon)), ribbons.data(),
               GL_STREAM_DRAW);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  DrawCalls::arraysInstanced(GL_TRIANGLE_STRIP, 4, static_cast<GLsizei>(ribbons.size()));
}

void LightMap::bind(ShaderProgram& program, int face) const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, filter_);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, filter_);
  program.set("lightMap", 0);
  program.set("layer", static_cast<float>(face));
  program.set("lightScale", 0.5F / reach_);
}

}  // namespace platon
