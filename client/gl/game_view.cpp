#include "client/gl/game_view.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "client/hud/hud_space.h"
#include "client/ui/overlay.h"

namespace platon {
namespace {

constexpr int kGap = 4;  // between two views, pixels

float footOf(std::span<const Overlay> parts, const Font& font) {
  float foot = 0;
  for (const Overlay& part : parts) foot = std::max(foot, Overlay::kHeight - boundsOf(part, font).low.y);
  return foot;
}

}  // namespace

GameView::GameView(std::uint32_t width, std::uint32_t height)
    : renderer_(width, height, font_), width_(width), height_(height) {
  camera_.resize(width, height);
}

void GameView::resize(std::uint32_t width, std::uint32_t height) {
  if (width == 0 || height == 0) return;
  renderer_.resize(width, height);
  width_ = width;
  height_ = height;
}

float GameView::screenWidth() const { return Overlay::widthFor(width(), height()); }

void GameView::draw(const Scene* scene, const HudStatus& status, const Settings& settings, const Overlay& menu,
                    double seconds, std::span<const Overlay> more) {
  const Camera& camera = camera_.camera();
  HudStatus shown = shownStatus(status, settings);
  shown.foot = footOf(more, font_);
  std::vector<Overlay> overlays;
  others_.clear();
  camera_.resize(width_, height_);
  if (scene != nullptr) {
    if (std::exchange(showsGroup_, false) && groupStage_.lock() == scene->stage) camera_.goOnFrom(group_.view());
    group_.reset();
    moveCamera(camera_, *scene, settings, seconds);
    fold(*scene);
    rolls_ = {camera.rollOf(scene->focus)};
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

HudStatus GameView::shownStatus(const HudStatus& status, const Settings& settings) const {
  HudStatus shown = status;
  shown.scale = textScale(settings);
  if (shown.notice.empty()) shown.notice = notice_;
  if (settings.netGraph) shown.netGraph = &netGraph_;
  return shown;
}

void GameView::drawShared(std::span<const Scene> scenes, const HudStatus& status, const Settings& settings,
                          const Overlay& menu, double seconds) {
  const bool one = isOneView(scenes, settings, seconds);
  HudStatus shown = shownStatus(status, settings);
  shown.assembling = camera_.folded() < 1;
  camera_.takeFadingCut();  // several views fade no cuts
  renderer_.setFade(fadeLeft_ = 0);
  const std::size_t views = one ? 1 : scenes.size();
  const std::vector<PictureArea> areas = areasOf(views, {width_, height_}, kGap);
  const float unit = Overlay::kHeight / static_cast<float>(height_);
  std::vector<SceneView> parts;
  std::vector<HudPane> panes;
  for (std::size_t i = 0; i < views; ++i) {
    const Camera& camera = cameraOf(scenes, i).camera();
    parts.push_back({&scenes[i], &camera, areas[i].corner});
    panes.push_back({&scenes[i], &camera, unit * glm::vec2(areas[i].corner), unit * glm::vec2(areas[i].size)});
  }
  std::array overlays{makeSharedHud(panes, shown, font_, screenWidth()), menu};
  const PictureStyle style = styleOf(settings);
  if (style.highContrast) std::for_each(overlays.begin(), overlays.end(), raiseContrast);
  renderer_.setFaceNumbers(settings.faceNumbers);
  one ? renderer_.draw(scenes[0], camera_.camera(), overlays, style) : renderer_.draw(parts, overlays, style);
}

GameCamera& GameView::cameraOf(std::span<const Scene> scenes, std::size_t view) {
  return view == 0 ? camera_ : others_[localSlotOf(scenes[view])];
}

// Moves all cameras. Whether one view shows all players; while the solid is put together, it is that of the first one.
bool GameView::isOneView(std::span<const Scene> scenes, const Settings& settings, double seconds) {
  const Scene& first = scenes.front();
  const bool isNew = groupStage_.lock() != first.stage;
  const bool wasOne = group_.together() && settings.views == SharedViews::kOne;
  const bool movesWhole = isNew || wasOne || camera_.flying();
  if (movesWhole) {
    camera_.resize(width_, height_);
    moveCamera(camera_, first, settings, seconds);
  }
  if (isNew || camera_.flying()) group_.reset();
  groupStage_ = first.stage;
  std::vector<Pose> players;
  for (const Scene& scene : scenes) players.push_back(scene.focus);
  group_.move(players, first.stage->mesh, settings.comfort, settings.zoom, double{1} * width_ / height_,
              camera_.camera().shownView(), seconds);
  fold(first);
  const bool one = camera_.flying() || (group_.together() && settings.views == SharedViews::kOne);
  if (!one) divide(scenes, settings, movesWhole ? 0 : seconds);
  if (one && !movesWhole) {
    camera_.resize(width_, height_);
    moveCamera(camera_, first, settings, 0);
  }
  showsGroup_ = one && !camera_.flying();
  if (showsGroup_) camera_.show(group_.view(), first.stage->mesh);
  rolls_.clear();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const ViewPoint& own = (one ? camera_ : cameraOf(scenes, i)).camera().viewPoint();
    rolls_.push_back(rollIn(showsGroup_ ? group_.view() : own, scenes[i].focus));
  }
  return one;
}

void GameView::divide(std::span<const Scene> scenes, const Settings& settings, double seconds) {
  const std::vector<PictureArea> areas = areasOf(scenes.size(), {width_, height_}, kGap);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    GameCamera& camera = cameraOf(scenes, i);
    camera.resize(static_cast<std::uint32_t>(areas[i].size.x), static_cast<std::uint32_t>(areas[i].size.y));
    moveCamera(camera, scenes[i], settings, seconds);
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

void GameView::moveCamera(GameCamera& camera, const Scene& scene, const Settings& settings, double seconds) {
  camera.setComfort(settings.comfort, settings.zoom);
  camera.setArrived(scene.attempt && scene.attempt->arrived);
  camera.setLongFall(scene.longFall);
  camera.setBegun(scene.begun);
  camera.move(scene.focus, scene.stage, scene.elements, &camera == &camera_ ? look_ : LookInput(), seconds);
}

void GameView::fold(const Scene& scene) {
  const double folded = camera_.folded();
  const StageModel& stage = *scene.stage;
  renderer_.setPlaces(folded < 1 ? foldedPlaces(stage.mesh, stage.goal.face, folded) : std::vector<glm::dmat4>());
}

}  // namespace platon
