#include "client/gl/renderer.h"

#include <cstddef>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "client/gl/gl_objects.h"
#include "client/scene/palette.h"

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

// The beam calls until the goal is reached, flares up then, and stays as a faint light.
float beamStrength(const GoalMotion& goal) {
  return static_cast<float>(1 - 0.7 * goal.opened() + 2 * (1 - goal.burst()));
}

// What is drawn of the faces.
struct SolidViews {
  std::vector<FaceView> faces;      // that are seen, also from inside
  std::vector<FaceView> outer;      // that are seen from outside, with what is on them
  std::vector<FaceView> onlyWalls;  // whose walls may be seen without them
};

SolidViews viewsOf(const SolidMesh& mesh, const Camera& camera, std::span<const glm::dmat4> places) {
  SolidViews views;
  views.faces = places.empty() ? visibleFaces(mesh, camera) : facesAt(places, camera);
  if (places.empty()) {
    views.outer = views.faces;
    views.onlyWalls = facesBeyondTheHorizon(mesh, camera);
    return views;
  }
  for (const FaceView& view : views.faces) (view.eye.z > 0 ? views.outer : views.onlyWalls).push_back(view);
  return views;
}

// Moves a player with the face on which it is.
void carry(PlayerDrawing& player, BallMotion& ball, const SolidMesh& mesh, std::span<const glm::dmat4> places) {
  const int face = mesh.faceTowards(player.pose.normal);
  const glm::dmat4 carried = places[static_cast<std::size_t>(face)] * glm::inverse(mesh.faceToWorld(face));
  const glm::dmat3 turn(carried);
  player.pose = {glm::dvec3(carried * glm::dvec4(player.pose.position, 1)), turn * player.pose.up,
                 turn * player.pose.normal};
  ball.turn(glm::quat_cast(turn));
}

// What may be seen through is blended; faces and walls are drawn without it.
void setDefaults() {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

Renderer::Renderer(std::uint32_t width, std::uint32_t height, const Font& font)
    : target_(width, height, quality_.samples, quality_.scale), textPainter_(font) {}

void Renderer::resize(std::uint32_t width, std::uint32_t height) {
  const bool same = width == target_.width() && height == target_.height();
  if (!same && width != 0 && height != 0) target_ = RenderTarget(width, height, quality_.samples, quality_.scale);
}

void Renderer::draw(const Scene& scene, const Camera& camera, std::span<const Overlay> overlays,
                    const PictureStyle& style) {
  drawScene(scene, camera, target_, style);
  panes_.clear();
  if (!painted_) return;
  target_.resolve();
  drawOverlays(overlays);
}

void Renderer::draw(std::span<const SceneView> views, std::span<const Overlay> overlays, const PictureStyle& style) {
  panes_.resize(views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    fit(panes_[i], *views[i].camera);
    drawScene(*views[i].scene, *views[i].camera, *panes_[i], style);
    if (painted_) panes_[i]->resolve();
  }
  if (!painted_) return;
  target_.clearPlain();
  for (std::size_t i = 0; i < views.size(); ++i) {
    const glm::uvec2 corner(views[i].corner);
    panes_[i]->copyInto(target_, corner.x, target_.height() - corner.y - panes_[i]->height());
  }
  target_.bindPlain();
  drawOverlays(overlays);
}

void Renderer::fit(std::unique_ptr<RenderTarget>& pane, const Camera& camera) const {
  if (pane && pane->width() == camera.width() && pane->height() == camera.height()) return;
  pane = std::make_unique<RenderTarget>(camera.width(), camera.height(), quality_.samples, quality_.scale);
}

void Renderer::drawScene(const Scene& scene, const Camera& camera, const RenderTarget& target,
                         const PictureStyle& style) {
  const StageModel& stage = *scene.stage;
  Follow& follow = follows_[localSlotOf(scene)];
  const bool particles = style.animated && !style.highContrast && quality_.particles;
  StagePainter::Decoration decoration;
  decoration.seconds = style.animated ? static_cast<float>(scene.seconds) : 0;
  decoration.numbers = faceNumbers_;
  decoration.trails = advance(scene, follow, particles);
  decoration.goal = follow.goal;
  decoration.crossing = follow.crossing;
  if (!style.animated || !style.flashes) decoration.goal.settle();
  if (!style.animated) decoration.crossing.reset();
  if (!style.flashes) decoration.crossing.darken();
  stagePainter_.prepare(scene, quality_.fine, style.highContrast, style.animated);
  scheme_ = style.highContrast ? highContrast(stage.scheme()) : stage.scheme();
  ballPainter_.setFine(quality_.fine);
  if (!painted_) return;
  beginPicture(target);
  drawSolid(scene, camera, target, decoration);
  for (const PlayerDrawing& player : scene.players) drawPlayer(player, balls_.at(player.slot), camera, style);
  if (particles) skyPainter_.drawMotes(stage.scheme(), camera, stage.mesh.circumradius(), scene.seconds);
  for (std::size_t i = 0; i < scene.ghosts.size(); ++i) drawPlayer(scene.ghosts[i], ghosts_[i], camera, style);
  beamPainter_.draw(stage, camera, beamStrength(decoration.goal), decoration.seconds);
}

void Renderer::drawSolid(const Scene& scene, const Camera& camera, const RenderTarget& target,
                         const StagePainter::Decoration& decoration) {
  const StageModel& stage = *scene.stage;
  const SolidViews views = viewsOf(stage.mesh, camera, places_);
  stagePainter_.drawFaces(stage, views.faces);
  {
    const DecalScope scope;
    stagePainter_.drawBelow(scene, views.outer, decoration, textPainter_);
  }
  const glm::uvec2 pixels(target.sampledWidth(), target.sampledHeight());
  stagePainter_.drawWalls(stage, views.outer, pixels, decoration.crossing);
  stagePainter_.drawWalls(stage, views.onlyWalls, pixels, decoration.crossing);
  {
    const DecalScope scope;
    stagePainter_.drawAbove(scene, views.outer, textPainter_);
  }
}

void Renderer::drawPlayer(PlayerDrawing player, BallMotion ball, const Camera& camera, const PictureStyle& style) {
  if (!style.animated || !style.flashes) player.flash = 0;
  if (!style.animated) ball.settle();
  if (const auto stage = stage_.lock(); stage && !places_.empty()) carry(player, ball, stage->mesh, places_);
  ballPainter_.draw(player, ball, camera, style.highContrast, textPainter_);
}

// Moves balls and goal on to this moment. Returns the trails.
FaceMarks Renderer::advance(const Scene& scene, Follow& follow, bool particles) {
  if (stage_.lock() != scene.stage) {
    balls_.clear();
    ghosts_.clear();
    for (auto& [slot, each] : follows_) each.crossing.reset();
  }
  stage_ = scene.stage;
  follow.goal.advance(scene.attempt && scene.attempt->arrived, scene.seconds);
  auto marks = std::make_shared<std::vector<FaceMark>>();
  for (const PlayerDrawing& player : scene.players) {
    BallMotion& ball = balls_.try_emplace(player.slot, StageModel::kPlayerRadius).first->second;
    ball.advance(scene.stage->mesh, player.pose, scene.seconds);
    if (particles) ball.addMarks(player.colour, scene.stage->scheme().wall, *marks);
  }
  if (!scene.players.empty() && scene.players.back().local)
    follow.crossing.advance(*scene.stage, scene.elements, scene.players.back().pose, scene.seconds);
  ghosts_.resize(scene.ghosts.size(), BallMotion(StageModel::kPlayerRadius));
  for (std::size_t i = 0; i < scene.ghosts.size(); ++i)
    ghosts_[i].advance(scene.stage->mesh, scene.ghosts[i].pose, scene.seconds);
  return marks;
}

void Renderer::beginPicture(const RenderTarget& target) {
  skyPainter_.prepare(scheme_, target.sampledWidth(), target.sampledHeight());
  target.bindSampled();
  setDefaults();
  DrawCalls::clear(GL_DEPTH_BUFFER_BIT);
  skyPainter_.drawSky();
}

void Renderer::setQuality(const Quality& quality) {
  const bool same = quality.samples == quality_.samples && quality.scale == quality_.scale;
  quality_ = quality;
  if (same) return;
  target_ = RenderTarget(target_.width(), target_.height(), quality.samples, quality.scale);
  panes_.clear();
}

void Renderer::drawEmpty(std::span<const Overlay> overlays) {
  if (!painted_) return;
  beginPicture(target_);
  target_.resolve();
  drawOverlays(overlays);
}

void Renderer::drawOverlays(std::span<const Overlay> overlays) {
  if (fadeOpacity_ > 0) fade_.draw(fadeOpacity_);
  glDisable(GL_DEPTH_TEST);
  const float aspect = static_cast<float>(target_.width()) / static_cast<float>(target_.height());
  for (const Overlay& overlay : overlays) overlayPainter_.draw(overlay, aspect, textPainter_);
}

}  // namespace platon
