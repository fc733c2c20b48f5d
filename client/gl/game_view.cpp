#include "client/gl/game_view.h"

#include <vector>

namespace platon {

GameView::GameView(std::uint32_t width, std::uint32_t height) : renderer_(width, height, font_) {
  camera_.resize(width, height);
}

void GameView::resize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return;
  renderer_.resize(width, height);
  camera_.resize(width, height);
}

void GameView::draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Menu& menu,
                    double seconds) {
  const float width = Overlay::kHeight * static_cast<float>(camera_.width()) / static_cast<float>(camera_.height());
  std::vector<Overlay> overlays;
  if (scene != nullptr) {
    moveCamera(*scene, settings, seconds);
    overlays.push_back(makeHud(*scene, camera_, status, font_));
  } else {
    overlays.push_back(makeEmptyHud(status, font_, width));
  }
  if (settings.netGraph) overlays.push_back(netGraph_.overlay(font_, width));
  overlays.push_back(menu.overlay(settings, font_, width));
  if (scene != nullptr) {
    renderer_.draw(*scene, camera_, overlays, !settings.comfort.reducedMotion);
  } else {
    renderer_.drawEmpty(camera_, overlays);
  }
}

void GameView::moveCamera(const Scene& scene, const Settings& settings, double seconds) {
  camera_.setComfort(settings.comfort);
  camera_.setZoom(settings.zoom);
  if (stage_.lock() == scene.stage) {
    camera_.lerp(scene.focus, scene.stage->mesh, seconds);
  } else {
    camera_.set(scene.focus, scene.stage->mesh, camera_.width(), camera_.height());
  }
  stage_ = scene.stage;
  roll_ = camera_.rollOf(scene.focus);
}

}  // namespace platon
