#include "client/gl/paint/ball_painter.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "client/gl/gl_objects.h"
#include "client/scene/face_view.h"

namespace platon {
namespace {

// Parts of each edge of the icosahedron that is subdivided into a ball.
constexpr int kFine = 6;
constexpr int kCoarse = 3;

constexpr float kMaxWhite = 0.6F;  // largest share of white in a player who flashes

struct BallMesh {
  std::vector<glm::vec3> points;
  std::vector<std::uint16_t> triangles;
};

using Corners = std::array<glm::dvec3, 3>;

void addPoints(BallMesh& ball, const Corners& corners, int divisions) {
  for (int i = 0; i <= divisions; ++i) {
    for (int j = 0; i + j <= divisions; ++j) {
      const glm::dvec3 weights(divisions - i - j, i, j);
      ball.points.emplace_back(
          glm::normalize(corners[0] * weights.x + corners[1] * weights.y + corners[2] * weights.z));
    }
  }
}

// Triangulates a face. Its points are in rows, each one shorter than the row before.
void addTriangles(BallMesh& ball, std::size_t first, int divisions) {
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t index : {a, b, c}) ball.triangles.push_back(static_cast<std::uint16_t>(index));
  };
  for (auto length = static_cast<std::size_t>(divisions) + 1; length > 1; --length) {
    const std::size_t next = first + length;
    for (std::size_t j = 0; j + 1 < length; ++j) {
      add(first + j, next + j, first + j + 1);
      if (j + 2 < length) add(next + j, next + j + 1, first + j + 1);
    }
    first = next;
  }
}

void addUnitBall(BallMesh& ball, int divisions) {
  const SolidMesh mesh(SolidKind::kIcosahedron, 1);
  for (int face = 0; face < mesh.faces(); ++face) {
    const std::size_t first = ball.points.size();
    addPoints(ball,
              {mesh.toWorld(face, mesh.polygon()[0]), mesh.toWorld(face, mesh.polygon()[1]),
               mesh.toWorld(face, mesh.polygon()[2])},
              divisions);
    addTriangles(ball, first, divisions);
  }
}

// Where a ball is drawn.
struct Placement {
  glm::dvec3 centre{0};
  glm::dvec3 toEye{0, 0, 1};
};

Placement placementOf(const PlayerDrawing& player, const BallMotion& motion, const Camera& camera) {
  const glm::dvec3 centre = player.pose.position + motion.lift() * StageModel::kPlayerRadius;
  return {centre, glm::normalize(camera.eye() - centre)};
}

// Makes the ball shorter along up and wider across.
glm::dmat4 shapeOf(const PlayerDrawing& player, const BallMotion& motion) {
  const double squash = motion.squash();
  const glm::dvec3 up = player.pose.up;
  glm::dmat3 shape(1 + squash / 2);
  for (int column = 0; column < 3; ++column) shape[column] -= up * (up[column] * 1.5 * squash);
  return glm::translate(glm::dmat4(1), -up * squash) * glm::dmat4(shape);
}

// Transforms to clip space from the plane in front of the ball: units of its radius, +y is the player's up.
glm::mat4 labelToClip(const PlayerDrawing& player, const Camera& camera, const Placement& ball) {
  const glm::dvec3 right = glm::cross(player.pose.up, ball.toEye);
  const glm::dvec3 across = glm::length(right) > 1e-6 ? glm::normalize(right) : camera.right();
  const glm::dvec3 up = glm::cross(ball.toEye, across);
  constexpr double kRadius = StageModel::kPlayerRadius;
  const glm::dvec3 front = ball.centre + ball.toEye * (kRadius * 1.02);
  const glm::dmat4 toWorld(glm::dvec4(across * kRadius, 0), glm::dvec4(up * kRadius, 0),
                           glm::dvec4(ball.toEye * kRadius, 0), glm::dvec4(front, 1));
  return glm::mat4(camera.viewProjection() * toWorld);
}

// With high contrast, the outlines of others are bright as well.
Colour outlineOf(const PlayerDrawing& player, bool highContrast) {
  if (player.local) return Colour(1);
  return highContrast ? glm::mix(player.colour, Colour(1), 0.4F) : player.colour * 0.28F;
}

// The local player knows its ball: it has no number.
std::string labelOf(const PlayerDrawing& player) {
  if (player.finishSeconds) return "\u2713";
  return player.local ? "" : player.number;
}

}  // namespace

BallPainter::BallPainter() : program_("ball") {
  BallMesh ball;
  addUnitBall(ball, kFine);
  fineCount_ = static_cast<GLsizei>(ball.triangles.size());
  addUnitBall(ball, kCoarse);
  coarseCount_ = static_cast<GLsizei>(ball.triangles.size()) - fineCount_;
  const auto bytes = [](const auto& values) { return static_cast<GLsizeiptr>(values.size() * sizeof(values[0])); };
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, points_.name());
  glBufferData(GL_ARRAY_BUFFER, bytes(ball.points), ball.points.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, bytes(ball.triangles), ball.triangles.data(), GL_STATIC_DRAW);
}

void BallPainter::draw(const PlayerDrawing& player, const BallMotion& motion, const Camera& camera, bool highContrast,
                       TextPainter& text) {
  const Placement ball = placementOf(player, motion, camera);
  const glm::dmat4 toWorld =
      glm::scale(glm::translate(glm::dmat4(1), ball.centre), glm::dvec3(StageModel::kPlayerRadius));
  program_.use();
  program_.set("toClip", glm::mat4(camera.viewProjection() * toWorld));
  program_.set("turned", glm::mat4(glm::mat4_cast(motion.orientation())));
  program_.set("shaped", glm::mat4(shapeOf(player, motion)));
  program_.set("colour", glm::mix(player.colour, Colour(1), kMaxWhite * player.flash));
  program_.set("pattern", static_cast<int>(player.pattern));
  program_.set("outline", outlineOf(player, highContrast));
  program_.set("opacity", player.opacity);
  program_.set("toEye", glm::vec3(ball.toEye));
  program_.set("light", glm::vec3(lightOf(camera)));
  program_.set("up", glm::vec3(glm::normalize(player.pose.up + 0.9 * motion.lift())));
  glBindVertexArray(array_.name());
  glEnable(GL_CULL_FACE);
  const std::size_t first = fine_ ? 0 : static_cast<std::size_t>(fineCount_);
  DrawCalls::elements(GL_TRIANGLES, fine_ ? fineCount_ : coarseCount_, GL_UNSIGNED_SHORT,
                      bufferOffset(first * sizeof(std::uint16_t)));
  glDisable(GL_CULL_FACE);
  const std::string label = labelOf(player);
  if (label.empty()) return;
  text.addCentred(label, {0, 0}, label.size() > 2 ? 0.75F : 1.0F, {0.06F, 0.06F, 0.09F, 0.92F * player.opacity});
  text.flush(labelToClip(player, camera, ball), 0);
}

}  // namespace platon
