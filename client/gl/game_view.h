#pragma once

#include <cstdint>
#include <memory>

#include "client/gl/image.h"
#include "client/gl/renderer.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/hud.h"
#include "client/ui/menu.h"
#include "client/ui/net_graph.h"
#include "client/ui/settings.h"

namespace platon {

/// Draws the whole picture: scene, head-up display, net graph and menu. Requires the current OpenGL
/// context of a Window or an Offscreen, which must outlive it.
class GameView {
 public:
  /// The pictures have this size in pixels, at least 1 × 1. Throws std::runtime_error on an OpenGL error.
  GameView(std::uint32_t width, std::uint32_t height);

  /// No effect if a size is 0.
  void resize(std::uint32_t width, std::uint32_t height);

  /// Draws the next picture, `seconds` after the last one. When the stage changes, the camera jumps to its target.
  /// `scene` is null while there is no game.
  void draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Menu& menu, double seconds);

  /// Camera::rollOf the focus of the last scene, for Steering.
  double roll() const { return roll_; }
  NetGraph& netGraph() { return netGraph_; }

  /// Copies the last picture to the window.
  void present() const { renderer_.present(); }
  Image read() const { return renderer_.read(); }

 private:
  void moveCamera(const Scene& scene, const Settings& settings, double seconds);

  Font font_;
  Renderer renderer_;
  Camera camera_;
  NetGraph netGraph_;
  std::weak_ptr<const StageModel> stage_;  // stage of the last scene
  double roll_ = 0;
};

}  // namespace platon
