#include "client/gl/paint/face_painter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "client/gl/gl_objects.h"
#include "client/gl/shader_program.h"
#include "client/scene/face_view.h"
#include "client/scene/palette.h"
#include "client/scene/walls.h"

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

namespace {

constexpr float kSlope = 0.05F;    // how much a face is brighter on the side of the light
constexpr float kGridStep = 60;    // of large faces, on which nothing else may show how a ball moves, level units
constexpr float kLargeFace = 700;  // apothem from which a face has a grid
constexpr float kRim = 16;         // width of what is drawn with the bright edge, level units

}  // namespace

FacePainter::FacePainter() : face_("face"), rim_(shaderText("face.vert"), shaderText("rim.frag"), "rim") {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
}

void FacePainter::load(const StageModel& stage, bool shadows) {
  const auto apothem = static_cast<float>(stage.mesh.apothem());
  const float inner = 1 - std::min(kRim / apothem, 0.5F);
  std::vector<glm::vec2> corners(stage.mesh.polygon().begin(), stage.mesh.polygon().end());
  const std::size_t edges = corners.size();
  for (std::size_t i = 0; i < edges; ++i) corners.push_back(corners[i] * inner);
  for (std::size_t i = 0; i <= edges; ++i) {
    corners.push_back(corners[i % edges]);
    corners.push_back(corners[edges + i % edges]);
  }
  edges_ = static_cast<GLsizei>(edges);
  glBindBuffer(GL_ARRAY_BUFFER, corners_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(glm::vec2)), corners.data(),
               GL_STATIC_DRAW);
  lightMap_.bake(stage, shadows);
}

// Most of a face needs neither its edges nor a grid.
void FacePainter::draw(const StageModel& stage, std::span<const FaceView> views, bool highContrast) {
  const bool grid = stage.mesh.apothem() > kLargeFace;
  glDisable(GL_BLEND);
  glBindVertexArray(array_.name());
  for (const FaceView& view : views) {
    setAppearance(rim_, stage, view, highContrast);
    rim_.set("gridStep", grid ? kGridStep : 0.0F);
    if (grid) {
      DrawCalls::arrays(GL_TRIANGLE_FAN, edges_);
      continue;
    }
    DrawCalls::arrays(GL_TRIANGLE_STRIP, 2 * (edges_ + 1), 2 * edges_);
    setAppearance(face_, stage, view, highContrast);
    DrawCalls::arrays(GL_TRIANGLE_FAN, edges_, edges_);
  }
  glEnable(GL_BLEND);
}

void FacePainter::setAppearance(ShaderProgram& program, const StageModel& stage, const FaceView& view,
                                bool highContrast) const {
  useOnFace(program, stage, view);
  lightMap_.bind(program, view.face);
  const Colour colour = stage.faces[static_cast<std::size_t>(view.face)].colour;
  program.set("colour", highContrast ? highContrastFace(colour) : colour);
  program.set("lit", litOf(view));
  const glm::vec2 aside(faceLight(stage.mesh, view.face));
  program.set("slope", aside * (kSlope / static_cast<float>(stage.mesh.apothem())));
}

}  // namespace platon
