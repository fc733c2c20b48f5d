#include "client/scene/face_view.h"

#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace platon::face_view_test {
namespace {

constexpr double kSize = 480;

Camera cameraAt(const SolidMesh& mesh, int face, glm::dvec2 point) {
  Camera camera;
  camera.set(mesh.pose(face, point, 0.3), mesh, 1280, 720);
  return camera;
}

std::set<int> facesOf(const std::vector<FaceView>& views) {
  std::set<int> faces;
  for (const FaceView& view : views) faces.insert(view.face);
  return faces;
}

class FaceViewTest : public testing::TestWithParam<int> {
 protected:
  SolidMesh mesh_{static_cast<SolidKind>(GetParam()), kSize};
};

TEST_P(FaceViewTest, FacesBeyondTheHorizonAreNextToTheVisibleOnes) {
  for (int focus = 0; focus < mesh_.faces(); ++focus) {
    const Camera camera = cameraAt(mesh_, focus, {20, -30});
    const std::set<int> visible = facesOf(visibleFaces(mesh_, camera));
    const std::set<int> beyond = facesOf(facesBeyondTheHorizon(mesh_, camera));
    for (const int face : beyond) EXPECT_FALSE(visible.contains(face));
    for (const int face : visible) {
      for (int edge = 0; edge < mesh_.solid().edgesPerFace(); ++edge) {
        const int next = mesh_.solid().neighbour(face, edge).face;
        const bool faint = glm::dot(mesh_.normal(next), camera.back()) < -0.6;
        EXPECT_TRUE(visible.contains(next) || beyond.contains(next) || faint) << face << " " << next;
      }
    }
  }
}

TEST_P(FaceViewTest, VisibleFacesAreThoseWhoseOuterSideFacesTheCamera) {
  for (int focus = 0; focus < mesh_.faces(); ++focus) {
    const Camera camera = cameraAt(mesh_, focus, {20, -30});
    const std::vector<FaceView> views = visibleFaces(mesh_, camera);
    const std::set<int> faces = facesOf(views);
    EXPECT_EQ(faces.size(), views.size()) << "a face is listed twice";
    for (int face = 0; face < mesh_.faces(); ++face) {
      const glm::dvec3 toEye = camera.eye() - mesh_.toWorld(face, {0, 0});
      EXPECT_EQ(faces.contains(face), glm::dot(mesh_.normal(face), toEye) > 0) << "face " << face;
    }
    EXPECT_TRUE(faces.contains(focus));
  }
}

TEST_P(FaceViewTest, AViewIsTheCameraInTheFramesOfTheFace) {
  const Camera camera = cameraAt(mesh_, 0, {20, -30});
  const std::vector<FaceView> views = visibleFaces(mesh_, camera);
  ASSERT_FALSE(views.empty());
  for (const FaceView& view : views) {
    const glm::dmat4& toWorld = mesh_.faceToWorld(view.face);
    EXPECT_LT(glm::distance(glm::dvec3(toWorld * glm::dvec4(view.eye, 1)), camera.eye()), 1e-3);
    EXPECT_LT(glm::distance(glm::dvec3(toWorld * glm::dvec4(view.light, 0)), lightOf(camera)), 1e-5);
    const glm::dvec4 expected = camera.viewProjection() * glm::dvec4(mesh_.toWorld(view.face, {30, 40}), 1);
    EXPECT_LT(glm::distance(glm::dvec4(view.toClip * glm::vec4(30, 40, 0, 1)), expected), 1e-2);
  }
}

TEST(FaceView, TheLightMovesWithTheCamera) {
  const SolidMesh mesh(SolidKind::kHexahedron, kSize);
  for (int face = 0; face < mesh.faces(); ++face) {
    const Camera camera = cameraAt(mesh, face, {0, 0});
    const glm::dvec3 light = lightOf(camera);
    EXPECT_NEAR(glm::length(light), 1, 1e-12);
    EXPECT_LT(glm::dot(light, camera.right()), 0);
    EXPECT_GT(glm::dot(light, camera.up()), 0);
    EXPECT_GT(glm::dot(light, camera.back()), 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(AllSolids, FaceViewTest, testing::Range(0, kSolidKinds));

}  // namespace
}  // namespace platon::face_view_test
