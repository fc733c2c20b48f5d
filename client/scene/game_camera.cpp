#include "client/scene/game_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/scene/edge_crossing.h"
#include "client/scene/view_point.h"

namespace platon {

void CameraFlight::start(const ViewPoint& from) {
  from_ = from;
  progress_ = 0;
  speed_ = 1 / kSeconds;
}

void CameraFlight::skip() { speed_ = std::max(speed_, (1 - progress_) / kSkipSeconds); }

void CameraFlight::advance(double seconds) { progress_ = std::min(1.0, progress_ + speed_ * seconds); }

ViewPoint CameraFlight::towards(const ViewPoint& to, const SolidMesh& mesh) const {
  if (!flying()) return to;
  const double part = smootherstep(progress_);
  const glm::dquat orientation = glm::normalize(glm::slerp(from_.orientation, to.orientation, part));
  const glm::dvec3 fromCentre = glm::mix(from_.fromCentre(), to.fromCentre(), part);
  return drawnBack(mesh, orientation, fromCentre, 0.8 * std::sin(std::numbers::pi * part));
}

namespace {

constexpr double kWholeAngle = 0.7;  // radians from which the whole solid is seen

}  // namespace

void LookRound::update(const LookInput& input, double seconds) {
  if (input.held) {
    angles_ += kSpeed * seconds * input.direction + input.turn;
    angles_.x = std::remainder(angles_.x, 2 * std::numbers::pi);
    angles_.y = std::clamp(angles_.y, -kMaxUp, kMaxUp);
    return;
  }
  const double length = glm::length(angles_);
  if (length > 0) angles_ *= leftAfter(length, kReturn, kMaxReturn, seconds) / length;
}

ViewPoint LookRound::turned(const ViewPoint& view, const SolidMesh& mesh) const {
  if (angles_ == glm::dvec2(0)) return view;
  const glm::dquat turn =
      glm::angleAxis(angles_.x, glm::dvec3(0, 1, 0)) * glm::angleAxis(-angles_.y, glm::dvec3(1, 0, 0));
  const double part = glm::smoothstep(0.0, kWholeAngle, glm::length(angles_));
  return drawnBack(mesh, glm::normalize(view.orientation * turn), view.fromCentre(), part);
}

void CrossingPush::move(const Pose& player, double seconds) {
  age_ = std::min(age_ + seconds, kPause);
  const bool crossed = player_ && glm::dot(player_->normal, player.normal) < 1 - 1e-9 &&
                       glm::distance(player_->position, player.position) < EdgeCrossing::kMaxStep;
  if (crossed && age_ >= kPause) age_ = 0;
  player_ = player;
}

// It begins fast and ends without a jerk.
double CrossingPush::nearer() const {
  const double part = std::min(age_ / kSeconds, 1.0);
  return kNearer * 6.75 * part * (1 - part) * (1 - part);
}

namespace {

// Of the far view, so that several faces are seen.
const glm::dquat kLean = glm::angleAxis(0.35, glm::dvec3(0, 1, 0)) * glm::angleAxis(-0.45, glm::dvec3(1, 0, 0));

// The same rotation, without a jump from `last`.
glm::dquat continued(const glm::dquat& turn, const glm::dquat& last) {
  return glm::normalize(glm::dot(turn, last) < 0 ? -turn : turn);
}

}  // namespace

// In a fall, the view turns on with what the camera near the player turns, ever less. The other way, it turns to that
// camera wherever it is.
void FarView::move(const ViewPoint& near, bool falls, bool cuts, double seconds) {
  const glm::dquat turned = continued(near.orientation * glm::conjugate(near_), {1, 0, 0, 0});
  const bool begins = falls && held_ == 0;
  glm::dquat far = begins ? near.orientation : falls ? orientation(near_) : near_ * beyond_;
  if (falls && !begins) far = partOf(turned, 1 - smootherstep(away_)) * far;
  const bool turnsBack = held_ > 0 && held_ < 1;
  beyond_ = continued(glm::conjugate(near.orientation) * far, turnsBack ? beyond_ : glm::dquat(1, 0, 0, 0));
  near_ = near.orientation;
  const double back = std::max(kAwaySeconds, kBackSeconds * angleOfTurn(beyond_));
  const double time = cuts ? 1 : seconds / (falls ? kAwaySeconds : back);
  away_ = std::clamp(away_ + (falls ? time : -time), 0.0, 1.0);
  held_ = falls ? 1 : std::max(0.0, held_ - time);
}

glm::dquat FarView::orientation(const glm::dquat& near) const {
  return glm::normalize(near * partOf(beyond_, smootherstep(held_)));
}

ViewPoint FarView::view(const ViewPoint& near, const SolidMesh& mesh) const {
  if (away_ == 0 && held_ == 0) return near;
  const glm::dquat shown = glm::normalize(orientation(near.orientation) * partOf(kLean, smootherstep(away_)));
  const ViewPoint whole = drawnBack(mesh, shown, near.fromCentre(), 1);
  return {shown, shown * glm::mix(near.fromCentre(), whole.fromCentre(), smootherstep(away_))};
}

namespace {

// Parts of the time of a flight.
constexpr double kFlat = 0.1;    // until which the unfolding lies flat
constexpr double kFolded = 0.7;  // from which the solid is complete

}  // namespace

void GameCamera::setComfort(const CameraComfort& comfort, double zoom) {
  comfort_ = comfort;
  camera_.setComfort(comfort);
  camera_.setZoom(zoom);
  zooming_ = zooming_ || zoom != zoom_;
  zoom_ = zoom;
}

// What is seen over an edge changes smoothly when the way there opens or closes, also at a jump of the player.
void GameCamera::peek(const Pose& player, const StageModel& stage, const ElementStates& states, double seconds) {
  const std::vector<double> free = freeFaces(stage, states, player);
  if (peek_.size() != free.size()) peek_ = free;
  const double stay = std::exp(-kPeekRate * seconds);
  for (std::size_t face = 0; face < free.size(); ++face) peek_[face] = glm::mix(free[face], peek_[face], stay);
  camera_.setPeek(peek_);
}

void GameCamera::move(const Pose& player, const std::shared_ptr<const StageModel>& stage, const ElementStates& states,
                      const LookInput& look, double seconds) {
  const bool isKnown = stage_.lock() == stage;
  if (!isKnown) peek_.clear();
  peek(player, *stage, states, seconds);
  if (isKnown) {
    const glm::dvec3 before = camera_.viewPoint().eye;
    const glm::dquat turned = camera_.viewPoint().orientation;
    camera_.lerp(player, stage->mesh, seconds);
    const bool cut = camera_.viewPoint().eye != before || camera_.viewPoint().orientation != turned;
    fadingCut_ = cut && comfort_.view == CameraView::kFaceFade && !zooming_ && !flying();
    flight_.advance(seconds);
    begun_ = begun_ || begunNow_;
    approach(seconds);
    leaveOverview(seconds);
  } else {
    begin(player, *stage);
  }
  stage_ = stage;
  zooming_ = false;
  if (comfort_.reducedMotion) flight_.stop();
  look_.update(look, seconds);
  if (comfort_.instantCut && !look.held) look_.reset();
  camera_.setReach(flying() ? unfolding_.reach : 0);
  ViewPoint view = flightView(overview(player, stage->mesh), stage->mesh);
  push_.move(player, seconds);
  const double push = standsCalm() || longFall_ ? 0 : push_.nearer();
  view.eye += (kNearer * smootherstep(approach_) + push) * (player.position - view.eye);
  farView_.move(view, longFall_, comfort_.instantCut || comfort_.view != CameraView::kFollow, seconds);
  view = farView_.view(view, stage->mesh);
  camera_.show(look_.turned(view, stage->mesh));
}

void GameCamera::approach(double seconds) {
  if (standsCalm()) {
    approach_ = 0;
    return;
  }
  approach_ += arrived_ ? seconds / kApproachSeconds : -seconds / kWithdrawalSeconds;
  approach_ = std::clamp(approach_, 0.0, 1.0);
}

bool GameCamera::standsCalm() const {
  return comfort_.reducedMotion || comfort_.instantCut || comfort_.view != CameraView::kFollow;
}

void GameCamera::leaveOverview(double seconds) {
  if (comfort_.view != CameraView::kFollow) {
    overview_ = 0;
  } else if (begun_) {
    overview_ = comfort_.instantCut ? 0 : std::max(0.0, overview_ - seconds / kOverviewSeconds);
  }
}

// The view of the player, or on the way to it from that of the whole face.
ViewPoint GameCamera::overview(const Pose& player, const SolidMesh& mesh) {
  const ViewPoint& near = camera_.viewPoint();
  if (overview_ <= 0) return near;
  const ViewPoint whole = wholeFace_.view(player, mesh, zoom_);
  const double part = smootherstep(overview_);
  const glm::dquat orientation = glm::normalize(glm::slerp(near.orientation, whole.orientation, part));
  return {orientation, orientation * glm::mix(near.fromCentre(), whole.fromCentre(), part)};
}

double GameCamera::folded() const {
  if (!flying()) return 1;
  return smootherstep(std::clamp((flight_.progress() - kFlat) / (kFolded - kFlat), 0.0, 1.0));
}

// The flight begins where the whole unfolding is seen.
ViewPoint GameCamera::flightView(const ViewPoint& to, const SolidMesh& mesh) const {
  ViewPoint view = flight_.towards(to, mesh);
  if (!flying()) return view;
  const double part = glm::smoothstep(kFlat / 2, kFolded, flight_.progress());
  view.eye = view.orientation * glm::mix(unfolding_.view.fromCentre(), view.fromCentre(), part);
  return view;
}

void GameCamera::begin(const Pose& player, const StageModel& stage) {
  look_.reset();
  fadingCut_ = false;
  flight_.stop();
  approach_ = 0;
  farView_.reset();
  push_ = CrossingPush();
  begun_ = begunNow_;
  wholeFace_.reset();
  overview_ = begun_ || comfort_.view != CameraView::kFollow ? 0 : 1;
  const Pose goal = stage.mesh.pose(stage.goal.face, stage.goal.place, stage.goal.angle);
  camera_.setPeek({});
  camera_.set(goal, stage.mesh, camera_.width(), camera_.height());
  if (flights_ && !comfort_.instantCut) {
    flight_.start(camera_.viewPoint());
    unfolding_ = viewOfUnfolding(stage.mesh, goal, double{1} * camera_.width() / camera_.height());
  }
  camera_.setPeek(peek_);
  camera_.set(player, stage.mesh, camera_.width(), camera_.height());
}

}  // namespace platon
