#include "client/editor/editor_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"
#include "client/ui/overlay.h"

namespace platon {
namespace {

constexpr double kAside = 0.42;  // radians by which the first picture is turned, so that more faces are seen
constexpr double kFarthest = 2 * CameraTarget::kWholeSolid;
constexpr double kNearest = 100;                            // level units above the face
constexpr double kTurn = 6 * std::numbers::pi / 180;        // by one press of an arrow key
constexpr double kNotches = 1;                              // by one press of Page Up
constexpr double kNotch = 1.15;                             // factor of the distance from the face
constexpr double kViewHeight = 2 * CameraTarget::kTangent;  // of the field of view, at distance 1

}  // namespace

void EditorCamera::showAll(const SolidMesh& mesh, const Pose& pose) {
  centre(pose);
  turn(-kAside, -kAside * 0.7);
  distance_ = CameraTarget::kWholeSolid * mesh.circumradius();
}

void EditorCamera::centre(const Pose& pose) {
  orientation_ = glm::normalize(glm::quat_cast(glm::dmat3(glm::cross(pose.up, pose.normal), pose.up, pose.normal)));
}

void EditorCamera::drag(const SolidMesh& mesh, glm::dvec2 way) {
  const double units = kViewHeight * (distance_ - mesh.inradius()) / double{Overlay::kHeight};
  turn(way.x * units / mesh.inradius(), -way.y * units / mesh.inradius());
}

void EditorCamera::turn(double right, double up) {
  orientation_ = glm::normalize(orientation_ * glm::angleAxis(-right, glm::dvec3(0, 1, 0)) *
                                glm::angleAxis(up, glm::dvec3(1, 0, 0)));
}

void EditorCamera::zoom(const SolidMesh& mesh, double notches) {
  const double above = (distance_ - mesh.inradius()) * std::pow(kNotch, -notches);
  distance_ = std::clamp(mesh.inradius() + above, mesh.inradius() + kNearest, kFarthest * mesh.circumradius());
}

void EditorCamera::resize(std::uint32_t w, std::uint32_t h) {
  width_ = w;
  height_ = h;
}

void EditorCamera::handle(const PointerEvent& event, const SolidMesh& mesh, bool turns) {
  using Kind = PointerEvent::Kind;
  if (turning_ && turns) drag(mesh, event.place - pointer_);
  pointer_ = event.place;
  if (event.kind == Kind::kScroll) zoom(mesh, event.scroll);
  const bool isButton = event.kind == Kind::kPress || event.kind == Kind::kRelease;
  if (isButton && event.button != PointerEvent::Button::kLeft) turning_ = event.kind == Kind::kPress;
}

void EditorCamera::look(const PointerEvent& event) {
  pointer_ = event.place;
  if (event.kind == PointerEvent::Kind::kRelease) turning_ = false;
}

bool EditorCamera::handle(const KeyEvent& event, const SolidMesh& mesh) {
  switch (event.key) {
    case Key::kArrowLeft:
      turn(kTurn, 0);
      return true;
    case Key::kArrowRight:
      turn(-kTurn, 0);
      return true;
    case Key::kArrowUp:
      turn(0, -kTurn);
      return true;
    case Key::kArrowDown:
      turn(0, kTurn);
      return true;
    case Key::kPageUp:
      zoom(mesh, kNotches);
      return true;
    case Key::kPageDown:
      zoom(mesh, -kNotches);
      return true;
    default:
      return false;
  }
}

Camera EditorCamera::camera(const SolidMesh& mesh) const {
  Camera camera;
  camera.resize(width_, height_);
  camera.place(orientation_ * glm::dvec3(0, 0, distance_), orientation_ * glm::dvec3(0, 1, 0), mesh);
  return camera;
}

}  // namespace platon
