#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "client/gl/image.h"
#include "client/gl/renderer.h"
#include "client/hud/hud.h"
#include "client/hud/net_graph.h"
#include "client/scene/camera_controls.h"
#include "client/scene/game_camera.h"
#include "client/scene/group_view.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/settings.h"

namespace platon {

/// Draws the whole picture: scene, head-up display, net graph and menu. Requires the current OpenGL
/// context of a Window or an Offscreen, which must outlive it.
class GameView {
 public:
  /// The pictures have this size in pixels, at least 1 × 1. Throws std::runtime_error on an OpenGL error.
  GameView(std::uint32_t width, std::uint32_t height);

  /// What the next pictures may cost.
  void setQuality(const Quality& quality) { renderer_.setQuality(quality); }
  /// Whether the next pictures are painted, as at first. If not, only all that moves in them goes on.
  void setPainted(bool painted) { renderer_.setPainted(painted); }
  bool painted() const { return renderer_.painted(); }
  /// No effect if a size is 0.
  void resize(std::uint32_t width, std::uint32_t height);

  static constexpr double kFadeSeconds = 0.2;  ///< of a cut of the camera that fades

  /// The next pictures show this text, unless the head-up display has another notice; empty: none.
  void setNotice(const std::string& notice) { notice_ = notice; }

  /// Draws the next picture, `seconds` after the last one. When the stage changes, the camera jumps to its target, or
  /// flies there. `scene` is null while there is no game. `more` is drawn at the lower edge, which the head-up display
  /// keeps clear, `menu` in front of everything.
  void draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Overlay& menu, double seconds,
            std::span<const Overlay> more = {});

  /// Draws the picture of several local players likewise: in one view while it can show all of them, unless the
  /// settings give each its own. `scenes`: as each sees it, from two on, the first player's first.
  void drawShared(std::span<const Scene> scenes, const HudStatus& status, const Settings& settings, const Overlay& menu,
                  double seconds);

  /// Draws a scene as a camera of the size of the picture sees it, and a menu and the notice in front of it. The notice
  /// stands to the right of `left` on the virtual screen.
  void drawBeside(const Scene& scene, const Camera& camera, const Settings& settings, const Overlay& menu, float left);
  /// Size of the picture in pixels.
  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// How the player looks round in the next pictures.
  void look(const LookInput& input) { look_ = input; }
  /// Whether a new stage begins with a flight from its goal to the player, unless the settings forbid it; not at first.
  void setFlights(bool flights) { camera_.setFlights(flights); }
  /// Whether the picture is on such a flight.
  bool flying() const { return camera_.flying(); }
  /// Ends the flight soon.
  void skip() { camera_.skipFlight(); }

  /// How the player of the last scene at this place in the list of scenes is turned on the screen (Camera::rollOf), for
  /// Steering.
  double roll(std::size_t view = 0) const { return view < rolls_.size() ? rolls_[view] : 0; }
  NetGraph& netGraph() { return netGraph_; }
  const Font& font() const { return font_; }
  /// Of the virtual screen.
  float screenWidth() const;
  /// Size of the virtual screen.
  glm::vec2 screen() const { return {screenWidth(), Overlay::kHeight}; }
  /// How much menus and display are enlarged in this picture.
  float textScale(const Settings& settings) const { return platon::textScale(settings.uiScale, height()); }

  /// Copies the last picture to the window.
  void present() const { renderer_.present(); }
  Image read() const { return renderer_.read(); }

 private:
  HudStatus shownStatus(const HudStatus& status, const Settings& settings) const;
  void fade(double seconds);
  void moveCamera(GameCamera& camera, const Scene& scene, const Settings& settings, double seconds);
  void fold(const Scene& scene);
  GameCamera& cameraOf(std::span<const Scene> scenes, std::size_t view);
  void divide(std::span<const Scene> scenes, const Settings& settings, double seconds);
  bool isOneView(std::span<const Scene> scenes, const Settings& settings, double seconds);

  Font font_;
  Renderer renderer_;
  std::uint32_t width_;
  std::uint32_t height_;
  GameCamera camera_;
  std::map<std::uint32_t, GameCamera> others_;  // of the local players but the first, by slot
  GroupView group_;
  bool showsGroup_ = false;  // the last picture was the group's
  std::weak_ptr<const StageModel> groupStage_;
  LookInput look_;
  std::string notice_;
  NetGraph netGraph_;
  double fadeLeft_ = 0;           // of a cut of the camera, 0 … 1
  std::vector<double> rolls_{0};  // by view
};

}  // namespace platon
