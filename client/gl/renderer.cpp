#include "client/gl/renderer.h"

#include <vector>

namespace platon {
namespace {

// While an instance exists, drawing on a face passes the depth test against that face and writes no depth.
class DecalScope {
 public:
  DecalScope() {
    glDepthMask(GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1, -2);
  }
  ~DecalScope() {
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDepthMask(GL_TRUE);
  }
  DecalScope(const DecalScope&) = delete;
  DecalScope& operator=(const DecalScope&) = delete;
};

void beginPicture() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace

Renderer::Renderer(std::uint32_t width, std::uint32_t height, const Font& font)
    : target_(width, height, kSamples), textPainter_(font) {}

void Renderer::resize(std::uint32_t width, std::uint32_t height) {
  const bool same = width == target_.width() && height == target_.height();
  if (!same && width != 0 && height != 0) target_ = RenderTarget(width, height, kSamples);
}

void Renderer::draw(const Scene& scene, const Camera& camera, std::span<const Overlay> overlays, bool animated) {
  const std::vector<FaceView> views = visibleFaces(scene.stage->mesh, camera);
  target_.bindSampled();
  beginPicture();
  stagePainter_.draw(scene.stage, views);
  {
    const DecalScope scope;
    stagePainter_.drawOnFaces(scene, views, animated ? static_cast<float>(scene.seconds) : 0, textPainter_);
  }
  for (const PlayerDrawing& player : scene.players) ballPainter_.draw(player, camera, textPainter_);
  backgroundPainter_.draw(camera);
  for (const PlayerDrawing& ghost : scene.ghosts) ballPainter_.draw(ghost, camera, textPainter_);
  drawOverlays(overlays);
}

void Renderer::drawEmpty(const Camera& camera, std::span<const Overlay> overlays) {
  target_.bindSampled();
  beginPicture();
  backgroundPainter_.draw(camera);
  drawOverlays(overlays);
}

void Renderer::drawOverlays(std::span<const Overlay> overlays) {
  target_.resolve();
  glDisable(GL_DEPTH_TEST);
  const float aspect = static_cast<float>(target_.width()) / static_cast<float>(target_.height());
  for (const Overlay& overlay : overlays) overlayPainter_.draw(overlay, aspect, textPainter_);
}

}  // namespace platon
