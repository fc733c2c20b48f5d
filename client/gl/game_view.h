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

/// What the player sees: the scene through the camera, head-up display, connection graph and menu. Needs the current
/// OpenGL context of a Window or an Offscreen, which outlives it.
class GameView {
 public:
  /// Pictures of this size in pixels, at least 1 × 1. Throws std::runtime_error when OpenGL refuses something.
  GameView(std::uint32_t width, std::uint32_t height);

  /// Without effect when a size is 0.
  void resize(std::uint32_t width, std::uint32_t height);

  /// Draws the next picture, `seconds` after the last one. On another stage than before, the camera is there at once.
  /// `scene` is null while there is no game.
  void draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Menu& menu, double seconds);

  /// For Steering: how the focus of the last scene is turned on the screen.
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
  std::weak_ptr<const StageModel> stage_;  // of the last scene
  double roll_ = 0;
};

}  // namespace platon
