#include "client/scene/ball_motion.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace platon {
namespace {

constexpr double kTrailGap = 4;   // between two spots of the trail, level units
constexpr double kStill = 0.01;   // a shorter way is none, level units
constexpr double kLanding = 140;  // change of the speed along up that is a landing or a take-off, level units a second
constexpr double kFullSquash = 700;  // the same of a landing with the largest squash
constexpr double kSquashRate = 11;   // of the recovery, per second
constexpr std::size_t kMaxDust = 4;
constexpr int kParticles = 7;  // of a landing

float fading(double age, double duration) { return static_cast<float>(std::clamp(1 - age / duration, 0.0, 1.0)); }

}  // namespace

void BallMotion::advance(const SolidMesh& mesh, const Pose& pose, double seconds) {
  const double passed = seconds - seconds_;
  const glm::dvec3 way = pose.position - pose_.position;
  if (!begun_ || passed < 0 || glm::length(way) > kMaxStep) return begin(mesh, pose, seconds);
  if (passed == 0) return;
  const Spot spot = spotOf(mesh, pose, seconds);
  roll(way);
  feelGround(spot, glm::dot(way, pose.up) / passed, passed);
  const bool far =
      trail_.empty() || trail_.back().face != spot.face || glm::distance(trail_.back().place, spot.place) > kTrailGap;
  if (far && glm::length(way) > kStill) trail_.push_back(spot);
  pose_ = pose;
  seconds_ = seconds;
  lift_ = liftAt(mesh, pose.position, radius_);
  forget(seconds);
}

void BallMotion::turn(glm::dquat turn) {
  lift_ = turn * lift_;
  orientation_ = turn * orientation_;
}

void BallMotion::begin(const SolidMesh& mesh, const Pose& pose, double seconds) {
  *this = BallMotion(radius_);
  begun_ = true;
  pose_ = pose;
  seconds_ = seconds;
  lift_ = liftAt(mesh, pose.position, radius_);
}

// The ball rolls on the face like a marble.
void BallMotion::roll(glm::dvec3 way) {
  const glm::dvec3 axis = glm::cross(lift_, way);
  const double length = glm::length(axis);
  if (length < 1e-9) return;
  orientation_ = glm::normalize(glm::angleAxis(length / radius_, axis / length) * orientation_);
}

// A fall that ends and a rise that begins are seen as a change of the speed along up.
void BallMotion::feelGround(const Spot& spot, double rise, double passed) {
  const double change = rise - rise_;
  squash_ *= std::exp(-kSquashRate * passed);
  if (change > kLanding && std::max(std::abs(rise), std::abs(rise_)) > kLanding) {
    if (rise_ < -kLanding) squash_ = std::min(kMaxSquash, kMaxSquash * change / kFullSquash);
    if (dust_.empty() || spot.seconds - dust_.back().seconds > 0.12) dust_.push_back(spot);
  }
  rise_ = rise;
}

void BallMotion::forget(double seconds) {
  while (!trail_.empty() && seconds - trail_.front().seconds > kTrailSeconds) trail_.pop_front();
  while (!dust_.empty() && (seconds - dust_.front().seconds > kDustSeconds || dust_.size() > kMaxDust))
    dust_.pop_front();
}

BallMotion::Spot BallMotion::spotOf(const SolidMesh& mesh, const Pose& pose, double seconds) {
  const int face = mesh.faceTowards(pose.position);
  const glm::dmat4 toFace = glm::inverse(mesh.faceToWorld(face));
  return {face, glm::vec2(toFace * glm::dvec4(pose.position, 1)), glm::vec2(toFace * glm::dvec4(pose.up, 0)), seconds};
}

void BallMotion::addMarks(Colour ball, Colour wall, std::vector<FaceMark>& marks) const {
  for (const Spot& spot : trail_) {
    const float left = fading(seconds_ - spot.seconds, kTrailSeconds);
    const float width = static_cast<float>(radius_) * (0.35F + 0.75F * left);
    marks.push_back({spot.face, spot.place, spot.place, width, {ball, 0.20F * left * left}});
  }
  for (const Spot& spot : dust_) {
    const double age = seconds_ - spot.seconds;
    const float left = fading(age, kDustSeconds);
    const glm::vec2 right(spot.up.y, -spot.up.x);
    const glm::vec2 foot = spot.place - static_cast<float>(radius_) * spot.up;
    for (int i = 0; i < kParticles; ++i) {
      const float side = static_cast<float>(i) / (kParticles - 1) * 2 - 1;
      const float far = (1 - left * left) * (10 + 16 * std::abs(side));
      const float high = (1 - left) * (12 - 9 * std::abs(side)) + 2;
      const glm::vec2 place = foot + right * (side * (4 + far)) + spot.up * high;
      marks.push_back({spot.face, place, place, 2.2F + 3.5F * (1 - left), {wall, 0.6F * left}});
    }
  }
}

glm::dvec3 liftAt(const SolidMesh& mesh, glm::dvec3 point, double radius) {
  // A face whose plane is `reach` above the point has its edge at a distance of `radius`.
  const double reach = radius * std::sin(mesh.dihedral());
  glm::dvec3 sum(0);
  for (int face = 0; face < mesh.faces(); ++face) {
    const double below = std::max(0.0, mesh.inradius() - glm::dot(mesh.normal(face), point));
    sum += mesh.normal(face) * std::max(0.0, 1 - below / reach);
  }
  return glm::normalize(sum);
}

}  // namespace platon
