#include "client/scene/group_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "client/scene/camera_target.h"

namespace platon {
namespace {

constexpr double kInside = 0.72;   // of the half picture, in which all players are
constexpr double kToSolid = 0.3;   // of the way from the middle between them to that of what is seen of the solid
constexpr double kSameSide = 0.3;  // cosine of the largest turn to a target that is not a jump

// Whether the player's up points upwards in the picture.
bool isUpright(const Pose& player, glm::dquat orientation) {
  const glm::dvec2 up(glm::conjugate(orientation) * player.up);
  return up.y > GroupView::kDowns * glm::length(up);
}

// The view of players that stand still; nothing if it cannot show all of them.
std::optional<ViewPoint> viewOf(std::span<const Pose> players, const SolidMesh& mesh, double zoom, double aspect) {
  const Pose& first = players.front();
  glm::dvec3 back(0);
  glm::dvec3 middle(0);
  double own = 0;  // the distance from which a player sees itself
  for (const Pose& player : players) {
    const CameraTarget target = cameraTarget(player, mesh, zoom);
    back += target.back();
    middle += player.position / static_cast<double>(players.size());
    own = std::max(own, target.distance);
  }
  if (glm::length(back) < 0.1) return std::nullopt;
  back = glm::normalize(back);
  const glm::dquat orientation = levelOrientation(back, glm::cross(first.up, first.normal));
  if (!std::all_of(players.begin(), players.end(), [&](const Pose& player) { return isUpright(player, orientation); }))
    return std::nullopt;
  middle = glm::mix(middle, mesh.inradius() * back, kToSolid);
  const glm::dvec2 half = CameraTarget::kTangent * glm::max(glm::dvec2(1), glm::dvec2(aspect, 1 / aspect));
  double distance = own;
  for (const Pose& player : players) {
    const glm::dvec3 seen = glm::conjugate(orientation) * (player.position - middle);
    const glm::dvec2 needed = glm::abs(glm::dvec2(seen)) / (kInside * half);
    distance = std::max(distance, seen.z + std::max(needed.x, needed.y));
  }
  const ViewPoint view{orientation, middle + orientation * glm::dvec3(0, 0, distance)};
  for (const Pose& player : players) {
    const glm::dvec3 way = view.eye - player.position;
    const bool isSeen = glm::dot(player.normal, way) > GroupView::kSlant * glm::length(way);
    if (!isSeen || glm::length(way) > own / GroupView::kSmallest) return std::nullopt;
  }
  return view;
}

}  // namespace

void GroupView::move(std::span<const Pose> players, const SolidMesh& mesh, const CameraComfort& comfort, double zoom,
                     double aspect, const ViewPoint& own, double seconds) {
  const std::optional<ViewPoint> target = viewOf(players, mesh, zoom, aspect);
  seconds_ = target ? seconds_ + seconds : 0;
  const bool wasTogether = together_;
  together_ = target && (together_ || !isSet_ || seconds_ >= kTogetherSeconds);
  if (!isSet_ || !wasTogether) view_ = own;
  isSet_ = true;
  if (!target) return;
  const bool isElsewhere = glm::dot(view_.back(), target->back()) < kSameSide;
  if (comfort.instantCut || isElsewhere) view_ = *target;
  const double part = 1 - std::exp(-(comfort.reducedMotion ? kSlowRate : kRate) * seconds);
  view_.orientation = glm::normalize(glm::slerp(view_.orientation, target->orientation, part));
  view_.eye = glm::mix(view_.eye, target->eye, part);
}

std::vector<PictureArea> areasOf(std::size_t views, glm::ivec2 size, int gap) {
  const bool isWide = size.x >= size.y;
  const std::size_t columns = views == 1 || (views == 2 && !isWide) ? 1 : 2;
  const std::size_t rows = (views + columns - 1) / columns;
  // Of `size` units, the part `index` of `count` equal ones with gaps between them.
  const auto part = [gap](int length, std::size_t index, std::size_t count) {
    const auto n = static_cast<int>(count);
    const auto i = static_cast<int>(index);
    const int begin = (length + gap) * i / n;
    return std::pair{begin, std::max((length + gap) * (i + 1) / n - gap - begin, 1)};
  };
  std::vector<PictureArea> areas;
  for (std::size_t i = 0; i < views; ++i) {
    const std::size_t row = i / columns;
    const std::size_t inRow = std::min(columns, views - row * columns);
    const auto [x, width] = part(size.x, i % columns, inRow);
    const auto [y, height] = part(size.y, row, rows);
    areas.push_back({{x, y}, {width, height}});
  }
  return areas;
}

}  // namespace platon
