#include "platon/game/level.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "platon/exact/integer.h"
#include "platon/game/stage.h"
#include "shared/exact/hash.h"
#include "shared/game/crowding.h"
#include "shared/game/level_reader.h"

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
                          std::to_string(place.face) + "; remove some or spread them");
  }
  return places.empty();
}

void checkStart(const World& stage, const LevelPlace& start, Diagnostics& diagnostics) {
  if (isFreeForPlayer(stage, start.face, start.point, start.angle)) return;
  diagnostics.error(start.at, "the start is blocked: a line or a corner overlaps the player there");
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
  level->segments = std::move(draft.segments);
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
  LevelDraft draft = LevelReader(text, diagnostics).read();
  World stage;
  const bool hasFaces = draft.solid && draft.faceSize;
  if (hasFaces && checkTotal(draft, diagnostics) && checkCrowding(draft, diagnostics) && draft.start) {
    stage = buildStage(*draft.solid, *draft.faceSize, draft.segments);
    checkStart(stage, *draft.start, diagnostics);
  }
  LevelResult result;
  if (!diagnostics.hasError()) result.level = makeLevel(std::move(draft), std::move(stage), text);
  result.diagnostics = diagnostics.take();
  return result;
}

}  // namespace platon
