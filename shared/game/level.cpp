#include "platon/game/level.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/player.h"
#include "platon/game/stage.h"
#include "platon/physics/query.h"
#include "shared/exact/hash.h"
#include "shared/game/crowding.h"
#include "shared/game/level_reader.h"
#include "shared/game/seen_places.h"

namespace platon {
namespace {

// Reports the first segment that is too much. Returns whether there is none.
bool checkTotal(const LevelDraft& draft, Diagnostics& diagnostics) {
  std::int64_t total = 0;
  for (std::size_t face = 0; face < draft.segments.size(); ++face) {
    for (std::size_t i = 0; i < draft.segments[face].size(); ++i) {
      const Point size = draft.segments[face][i].b - draft.segments[face][i].a;
      total += std::max(std::abs(size.x), std::abs(size.y));
      if (total <= kMaxTotalUnits * kSubunitsPerUnit) continue;
      diagnostics.error(
          draft.positions[face][i],
          "the lines are together longer than " + std::to_string(kMaxTotalUnits) + " units: remove or shorten some");
      return false;
    }
  }
  return true;
}

// Reports each face that has too many segments in one place. Returns whether there is none.
bool checkCrowding(const LevelDraft& draft, Diagnostics& diagnostics) {
  const std::vector<std::vector<Segment>> none(draft.segments.size());
  const World faces = buildStage(*draft.solid, *draft.faceSize, none);
  const std::vector<CrowdedPlace> places = Crowding(faces.geometry(), draft.segments).find();
  for (const CrowdedPlace& place : places) {
    const auto units = [](std::int32_t subunits) { return std::to_string(divideRounded(subunits, kSubunitsPerUnit)); };
    constexpr std::int32_t side = (Crowding::kPlace + 2 * Crowding::kReach) / kSubunitsPerUnit;
    diagnostics.error(draft.positions[place.segmentFace][place.segment],
                      "too many lines in one place: more than " + std::to_string(kMaxSegmentsInReach) +
                          " touch the square of " + std::to_string(side) + " x " + std::to_string(side) +
                          " units round " + units(place.centre.x) + " " + units(place.centre.y) + " of face " +
                          std::to_string(place.face) + "; remove some or spread them out");
  }
  return places.empty();
}

void checkStart(const LevelDraft& draft, const World& stage, Diagnostics& diagnostics) {
  const LevelPlace& start = *draft.start;
  if (isFreeForPlayer(stage, draft.elements, start.face, start.point, start.angle)) return;
  diagnostics.error(start.at,
                    "the start is blocked: a line or a corner overlaps the player there; move the start or the line");
}

// A regular 16-gon around the player at every angle: the distance of its edges is 12.26 units.
Convex clearanceShape() {
  constexpr std::int32_t radius = kPlayerRadius + kSubunitsPerUnit / 2;
  std::vector<Point> vertices;
  for (std::int32_t i = 0; i < 16; ++i) vertices.push_back(rotate(Point(radius, 0), Angle(i * Angle::kTurn / 16)));
  return Convex(std::move(vertices));
}

// A player that returns to a checkpoint must be free there, whatever its angle and whichever doors are open.
void checkCheckpoints(const LevelDraft& draft, const World& stage, Diagnostics& diagnostics) {
  const Convex shape = clearanceShape();
  std::vector<SegmentRef> near;
  for (const Element& checkpoint : draft.elements) {
    if (!isCheckpoint(checkpoint.kind)) continue;
    findOverlaps(stage, checkpoint.face, shape, placeOf(checkpoint), near);
    const auto isInTheWay = [&](const SegmentRef& segment) {
      const Element* const element = findElement(draft.elements, segment.part, segment.index);
      return element == nullptr || canBlock(element->kind);
    };
    if (std::none_of(near.begin(), near.end(), isInTheWay)) continue;
    diagnostics.error(draft.positions[checkpoint.face][checkpoint.segment],
                      "the middle of this checkpoint, where players return, is within 12.5 units of a line that can "
                      "block, or of the edge of its face: move it");
  }
}

// `draft` is complete: reading it has reported no error.
std::shared_ptr<const Level> makeLevel(LevelDraft draft, World stage, std::string_view text) {
  auto level = std::make_shared<Level>();
  level->solid = *draft.solid;
  level->faceSize = *draft.faceSize;
  level->startFace = draft.start->face;
  level->start = draft.start->point;
  level->startAngle = draft.start->angle;
  level->goalFace = draft.goal->face;
  level->goal = draft.goal->point;
  level->goalPlaces = seenPlaces(stage.geometry(), {level->goalFace, level->goal}, kPlayerRadius + kGoalRadius);
  level->segments = std::move(draft.segments);
  level->positions = std::move(draft.positions);
  level->startAt = draft.start->at;
  level->goalAt = draft.goal->at;
  level->elements = std::move(draft.elements);
  for (const Element& element : level->elements) {
    if (opensDoors(element.kind)) level->doorNumbers |= element.bit();
    level->isTimed = level->isTimed || element.kind == ElementKind::kTimed;
  }
  level->players = draft.players.value_or(1);
  level->crossings = draft.crossings;
  level->needs = std::move(draft.needs);
  level->needsAt = draft.needsAt;
  level->title = std::move(draft.title);
  level->author = std::move(draft.author);
  level->text = text;
  level->hash = hashOf(text);
  level->world = std::move(stage);
  return level;
}

LevelResult tooLong() {
  return {nullptr, {{1, 1, true, "the level file is longer than " + std::to_string(kMaxLevelBytes) + " bytes"}}};
}

}  // namespace

LevelResult loadLevel(std::string_view text) {
  if (text.size() > kMaxLevelBytes) return tooLong();
  Diagnostics diagnostics;
  LevelDraft draft = readLevel(text, diagnostics);
  World stage;
  const bool hasFaces = draft.solid && draft.faceSize;
  if (hasFaces && checkTotal(draft, diagnostics) && checkCrowding(draft, diagnostics) && draft.start) {
    stage = buildStage(*draft.solid, *draft.faceSize, draft.segments);
    checkStart(draft, stage, diagnostics);
    checkCheckpoints(draft, stage, diagnostics);
  }
  LevelResult result;
  if (!diagnostics.hasError()) result.level = makeLevel(std::move(draft), std::move(stage), text);
  result.diagnostics = diagnostics.take();
  return result;
}

std::size_t segmentsInReach(const Level& level) { return Crowding(level.world.geometry(), level.segments).most(); }

}  // namespace platon
