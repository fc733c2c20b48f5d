#include "client/gl/game_view.h"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "client/hud/hud_space.h"
#include "client/ui/overlay.h"

namespace platon {
namespace {

float footOf(std::span<const Overlay> parts, const Font& font) {
  float foot = 0;
  for (const Overlay& part : parts) foot = std::max(foot, Overlay::kHeight - boundsOf(part, font).low.y);
  return foot;
}

}  // namespace

GameView::GameView(std::uint32_t width, std::uint32_t height) : renderer_(width, height, font_) {
  camera_.resize(width, height);
}

void GameView::resize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return;
  renderer_.resize(width, height);
  camera_.resize(width, height);
}

float GameView::screenWidth() const { return Overlay::widthFor(width(), height()); }

void GameView::draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Overlay& menu,
                    double seconds, std::span<const Overlay> more) {
  const Camera& camera = camera_.camera();
  HudStatus shown = status;
  shown.scale = textScale(settings);
  if (shown.notice.empty()) shown.notice = notice_;
  shown.foot = footOf(more, font_);
  if (settings.netGraph) shown.netGraph = &netGraph_;
  std::vector<Overlay> overlays;
  if (scene != nullptr) {
    moveCamera(*scene, settings, seconds);
    fade(seconds);
    shown.assembling = camera_.folded() < 1;
    overlays.push_back(makeHud(*scene, camera, shown, font_));
  } else {
    renderer_.setFade(fadeLeft_ = 0);
    overlays.push_back(makeEmptyHud(shown, font_, screenWidth()));
  }
  overlays.insert(overlays.end(), more.begin(), more.end());
  overlays.push_back(menu);
  const PictureStyle style = styleOf(settings);
  if (style.highContrast) std::for_each(overlays.begin(), overlays.end(), raiseContrast);
  renderer_.setFaceNumbers(settings.faceNumbers);
  if (scene != nullptr) {
    renderer_.draw(*scene, camera, overlays, style);
  } else {
    renderer_.drawEmpty(overlays);
  }
}

void GameView::drawBeside(const Scene& scene, const Camera& camera, const Settings& settings, const Overlay& menu,
                          float left) {
  const PictureStyle style = styleOf(settings);
  renderer_.setPlaces({});
  renderer_.setFade(fadeLeft_ = 0);
  const Overlay notice = makeNotice(notice_, font_, screenWidth() - left, textScale(settings));
  std::array overlays{menu, movedBy(notice, {left, 0})};
  if (style.highContrast) std::for_each(overlays.begin(), overlays.end(), raiseContrast);
  renderer_.draw(scene, camera, overlays, style);
}

// The picture before a cut lies over those after it. It is kept before they are drawn.
void GameView::fade(double seconds) {
  fadeLeft_ = std::max(0.0, fadeLeft_ - seconds / kFadeSeconds);
  if (camera_.takeFadingCut() && painted()) {
    renderer_.keepPicture();
    fadeLeft_ = 1;
  }
  renderer_.setFade(fadeLeft_);
}

void GameView::moveCamera(const Scene& scene, const Settings& settings, double seconds) {
  camera_.setComfort(settings.comfort, settings.zoom);
  camera_.setArrived(scene.attempt && scene.attempt->arrived);
  camera_.setLongFall(scene.longFall);
  camera_.setBegun(!scene.attempt || scene.attempt->seconds > 0);
  camera_.move(scene.focus, scene.stage, scene.elements, look_, seconds);
  const double folded = camera_.folded();
  const StageModel& stage = *scene.stage;
  renderer_.setPlaces(folded < 1 ? foldedPlaces(stage.mesh, stage.goal.face, folded) : std::vector<glm::dmat4>());
  roll_ = camera_.camera().rollOf(scene.focus);
}

}  // namespace platon
