#include <algorithm>
#include <string_view>
#include <tuple>

#include "platon/game/game.h"
#include "platon/game/level.h"
#include "tests/exactness/oracle/trace/trace_map.h"
#include "tests/exactness/step_check/conversions.h"
#include "tests/exactness/step_check/step_checker.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

using oracle::Vec;
using step_check::toPolygon;
using step_check::toSegment;
using step_check::toVec;

constexpr int kTicks = 8;

std::string diagnosticsFault(const std::vector<Diagnostic>& found, std::string_view text) {
  const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
  for (const Diagnostic& one : found) {
    const bool inText = one.line >= 1 && one.line <= lines && one.column >= 1 &&
                        one.column <= static_cast<std::int64_t>(text.size()) + 1;
    if (!inText) return "a diagnostic outside the text";
    const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
    if (one.message.empty() || !std::all_of(one.message.begin(), one.message.end(), printable)) {
      return "a message with unprintable characters";
    }
  }
  const auto before = [](const auto& a, const auto& b) {
    return std::tie(a.line, a.column) < std::tie(b.line, b.column);
  };
  return std::is_sorted(found.begin(), found.end(), before) ? std::string() : "diagnostics out of order";
}

oracle::TraceHeader headerOf(const Level& level) {
  oracle::TraceHeader header;
  header.solid = nameOf(level.solid);
  header.shape = toPolygon(playerShape().vertices());
  const oracle::Polygon polygon = toPolygon(facePolygon(level.solid, level.faceSize));
  for (const auto& part : level.world.geometry().parts) {
    oracle::TraceFace face;
    face.polygon = polygon;
    for (std::uint32_t i = 0; i < part->segmentOfWarp(0); ++i) face.lines.push_back(toSegment(part->segments[i]));
    for (const Warp& warp : part->warps)
      face.warps.push_back({toSegment(warp.from), warp.target, toSegment(warp.onto)});
    header.faces.push_back(std::move(face));
  }
  return header;
}

bool isInside(const oracle::Polygon& polygon, Vec point) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec here = polygon[i];
    if (oracle::cross(polygon[(i + 1) % polygon.size()] - here, point - here) < 0) return false;
  }
  return true;
}

std::string placesFault(const Level& level) {
  const oracle::Polygon polygon = toPolygon(facePolygon(level.solid, level.faceSize));
  if (level.startFace >= level.segments.size() || level.goalFace >= level.segments.size())
    return "start or goal on a missing face";
  if (!isInside(polygon, toVec(level.start))) return "the start is outside its face";
  if (!isInside(polygon, toVec(level.goal))) return "the goal is outside its face";
  const auto shape = playerShape().turned(level.startAngle);
  const auto area = oracle::OpenArea::placed(toPolygon(shape->vertices()), toVec(level.start));
  const MapGeometry& part = *level.world.geometry().find(level.startFace);
  for (std::uint32_t i = 0; i < part.segmentOfWarp(0); ++i) {
    const Element* const element = findElement(level.elements, level.startFace, i);
    const bool canBlock = element == nullptr || platon::canBlock(element->kind);
    if (canBlock && area.intersects(toSegment(part.segments[i]))) return "the start is not free";
  }
  return {};
}

std::string elementsFault(const Level& level) {
  if (level.elements.size() > 4096) return "too many elements";
  std::tuple<std::uint32_t, std::uint32_t> next;
  for (const Element& element : level.elements) {
    if (std::tuple(element.face, element.segment) < next) return "elements out of order";
    next = {element.face, element.segment + 1};
    if (element.face >= level.segments.size() || element.segment >= level.segments[element.face].size() ||
        !(level.segments[element.face][element.segment] == element.ends))
      return "an element is not its segment";
  }
  return {};
}

std::string validityFault(const Level& level, std::string_view text) {
  if (level.text != text) return "the level has a different text";
  if (level.faceSize < kMinFaceSize || level.faceSize > kMaxFaceSize) return "the face size is out of range";
  if (level.title.size() > 100 || level.author.size() > 100) return "title or author too long";
  oracle::TraceReport report;
  if (!oracle::TraceMap::make(headerOf(level), report) || !report.clean())
    return "invalid stage: " + report.messages().front();
  std::string fault = elementsFault(level);
  return fault.empty() ? placesFault(level) : fault;
}

std::string playFault(const std::shared_ptr<const Level>& level) {
  Game game(level);
  const Convex shape = playerShape();
  step_check::StepChecker checker({level->world.geometry(), shape, level->solid, level->faceSize, {}, level->elements});
  const std::vector<Input> inputs{{Input::kPresent | Input::kRight}, {Input::kPresent | Input::kLeft | Input::kJump}};
  for (int tick = 0; tick < kTicks; ++tick) {
    const OpenElements open = game.open();
    game.advance(inputs, &checker);
    if (std::string fault = checker.finishTick(open); !fault.empty()) return fault;
  }
  Game restored(level);
  return restored.restore(game.save()) && restored == game ? std::string() : "a saved game is not restored";
}

}  // namespace

std::string levelFault(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const LevelResult result = loadLevel(text);
  const bool refused =
      std::any_of(result.diagnostics.begin(), result.diagnostics.end(), [](auto& one) { return one.error; });
  if (refused == (result.level != nullptr)) return "a level despite errors, or no level without errors";
  if (std::string fault = diagnosticsFault(result.diagnostics, text); !fault.empty()) return fault;
  if (!result.level) return {};
  std::string fault = validityFault(*result.level, text);
  return fault.empty() ? playFault(result.level) : fault;
}

}  // namespace platon::fuzz
