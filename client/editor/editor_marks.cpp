#include "client/editor/editor_marks.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "levels/drawing/level_marks.h"

namespace platon {
namespace {

constexpr glm::vec4 kHovered(0.55F, 0.85F, 1.0F, 0.55F);
constexpr glm::vec4 kSelectedMark(1.0F, 0.85F, 0.40F, 0.75F);
constexpr glm::vec4 kDrawn(0.50F, 0.95F, 0.62F, 0.95F);
constexpr glm::vec4 kFaulty(1.0F, 0.35F, 0.28F, 0.85F);
constexpr glm::vec4 kPointer(1.0F, 1.0F, 1.0F, 0.95F);
constexpr glm::vec4 kReached(0.45F, 0.80F, 1.0F, 0.42F);
constexpr glm::vec4 kWay(1.0F, 0.80F, 0.30F, 0.90F);
constexpr float kReachedDot = 3.5F;  // level units
constexpr float kWayDot = 5;

constexpr auto kSegmentWidth = static_cast<float>(LevelMarks::kSegmentWidth);

FaceMark strokeOf(const EditedSegment& segment, float width, glm::vec4 colour) {
  return {segment.face, segment.a, segment.b, width, colour};
}

FaceMark dotAt(const FacePlace& at, float width, glm::vec4 colour) {
  return {at.face, at.place, at.place, width, colour};
}

}  // namespace

FaceMarks marksAbove(const EditorMarks& marks, double unit) {
  const float thin = std::max(kSegmentWidth, static_cast<float>(1.5 * unit));
  std::vector<FaceMark> all;
  for (const EditedSegment& segment : marks.faulty) all.push_back(strokeOf(segment, thin, kFaulty));
  if (marks.hovered) all.push_back(strokeOf(*marks.hovered, 2.2F * thin, kHovered));
  if (marks.selected) {
    all.push_back(strokeOf(*marks.selected, 2.2F * thin, kSelectedMark));
    for (const glm::dvec2 end : {marks.selected->a, marks.selected->b})
      all.push_back(dotAt({marks.selected->face, end}, 3.4F * thin, kSelectedMark));
  }
  for (const EditedSegment& segment : marks.drawn) all.push_back(strokeOf(segment, 1.2F * thin, kDrawn));
  if (marks.pointer) all.push_back(dotAt(*marks.pointer, 1.8F * thin, kPointer));
  return std::make_shared<const std::vector<FaceMark>>(std::move(all));
}

FaceMarks marksBelow(const LevelReport& report, bool showReached) {
  std::vector<FaceMark> all;
  if (showReached && report.reached) {
    for (const FacePlace& place : *report.reached) all.push_back(dotAt(place, kReachedDot, kReached));
  }
  for (const std::vector<FacePlace>& path : report.paths) {
    for (const FacePlace& place : path) all.push_back(dotAt(place, kWayDot, kWay));
  }
  return std::make_shared<const std::vector<FaceMark>>(std::move(all));
}

}  // namespace platon
