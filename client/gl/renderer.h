#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "client/gl/image.h"
#include "client/gl/overlay_painter.h"
#include "client/gl/paint/ball_painter.h"
#include "client/gl/paint/beam_painter.h"
#include "client/gl/paint/sky_painter.h"
#include "client/gl/paint/stage_painter.h"
#include "client/gl/render_target.h"
#include "client/gl/text_painter.h"
#include "client/quality/quality.h"
#include "client/scene/camera.h"
#include "client/scene/scene.h"
#include "client/ui/font.h"
#include "client/ui/overlay.h"
#include "client/ui/settings.h"

namespace platon {

/// How the player wants to see the game.
struct PictureStyle {
  bool animated = true;  ///< off: nothing moves but the players
  bool flashes = true;   ///< players and goal flash
  bool highContrast = false;
};

/// The style that the player has chosen.
inline PictureStyle styleOf(const Settings& settings) {
  const bool animated = !settings.comfort.reducedMotion;
  return {animated, animated && settings.flashes, settings.highContrast};
}

/// One of several views in a picture.
struct SceneView {
  const Scene* scene = nullptr;
  const Camera* camera = nullptr;  ///< of the size of the view
  glm::ivec2 corner{0};            ///< the upper left one, pixels
};

/// Draws scenes with OpenGL 3.3 core. The context must be current from construction to destruction.
class Renderer {
 public:
  /// The pictures have this size in pixels, at least 1 × 1. `font` must outlive the renderer. Throws
  /// std::runtime_error on an OpenGL error.
  Renderer(std::uint32_t width, std::uint32_t height, const Font& font);

  /// No effect if a size is 0 or both are unchanged.
  void resize(std::uint32_t width, std::uint32_t height);

  /// Draws the scene as `camera` sees it, then the overlays, in order. The camera must have the size of the picture.
  void draw(const Scene& scene, const Camera& camera, std::span<const Overlay> overlays,
            const PictureStyle& style = PictureStyle());

  /// Draws several scenes of one stage and moment, each in its part of the picture, then the overlays, in order.
  void draw(std::span<const SceneView> views, std::span<const Overlay> overlays,
            const PictureStyle& style = PictureStyle());

  /// Whether `draw` and `drawEmpty` paint, as at first. If not, `draw` only moves on what moves by itself.
  void setPainted(bool painted) { painted_ = painted; }
  bool painted() const { return painted_; }
  /// What the next pictures may cost.
  void setQuality(const Quality& quality);
  const Quality& quality() const { return quality_; }
  /// Whether faces have numbers instead of signs.
  void setFaceNumbers(bool numbers) { faceNumbers_ = numbers; }

  /// Where the faces of the next pictures are, with everything on them: transforms from their frames to space. Empty:
  /// in the solid.
  void setPlaces(std::vector<glm::dmat4> places) { places_ = std::move(places); }

  /// Keeps the last picture, for `setFade`.
  void keepPicture() { fade_.keep(target_); }
  /// How much of the kept picture lies over the scenes of the next pictures: 0 … 1.
  void setFade(double opacity) { fadeOpacity_ = opacity; }

  /// Draws the background and the overlays.
  void drawEmpty(std::span<const Overlay> overlays);

  /// Copies the last picture to the window, which must have the same size.
  void present() const { target_.present(); }
  /// Returns the last picture.
  Image read() const { return target_.read(); }

 private:
  // What one view follows from picture to picture.
  struct Follow {
    GoalMotion goal;
    EdgeCrossing crossing;
  };
  void drawScene(const Scene& scene, const Camera& camera, const RenderTarget& target, const PictureStyle& style);
  void beginPicture(const RenderTarget& target);
  void drawOverlays(std::span<const Overlay> overlays);
  FaceMarks advance(const Scene& scene, Follow& follow, bool particles);
  void drawSolid(const Scene& scene, const Camera& camera, const RenderTarget& target,
                 const StagePainter::Decoration& decoration);
  void fit(std::unique_ptr<RenderTarget>& pane, const Camera& camera) const;
  void drawPlayer(PlayerDrawing player, BallMotion ball, const Camera& camera, const PictureStyle& style);

  Quality quality_ = namedQuality(QualityLevel::kHigh).quality;
  bool faceNumbers_ = false;
  bool painted_ = true;
  std::vector<glm::dmat4> places_;
  std::weak_ptr<const StageModel> stage_;             // of the last scene
  std::map<std::uint32_t, BallMotion> balls_;         // by slot
  std::vector<BallMotion> ghosts_;                    // as Scene::ghosts
  std::map<std::uint32_t, Follow> follows_;           // by slot of the local player whose view it is
  std::vector<std::unique_ptr<RenderTarget>> panes_;  // of a picture with several views
  RenderTarget target_;
  PictureFade fade_;
  double fadeOpacity_ = 0;
  StagePainter stagePainter_;
  BallPainter ballPainter_;
  TextPainter textPainter_;
  OverlayPainter overlayPainter_;
  SkyPainter skyPainter_;
  BeamPainter beamPainter_;
  Scheme scheme_ = schemeOf(SolidKind::kHexahedron);  // of the last scene
};

}  // namespace platon
