#include "platon/game/level.h"

#include <utility>

#include "platon/game/stage.h"
#include "shared/exact/hash.h"
#include "shared/game/level_reader.h"

namespace platon {
namespace {

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
  if (draft.solid && draft.faceSize && draft.start) {
    stage = buildStage(*draft.solid, *draft.faceSize, draft.segments);
    checkStart(stage, *draft.start, diagnostics);
  }
  LevelResult result;
  if (!diagnostics.hasError()) result.level = makeLevel(std::move(draft), std::move(stage), text);
  result.diagnostics = diagnostics.take();
  return result;
}

}  // namespace platon
