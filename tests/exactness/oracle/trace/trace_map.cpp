#include "tests/exactness/oracle/trace/trace_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "tests/exactness/oracle/trace/face_checks.h"

namespace platon::oracle {
namespace {

constexpr std::int64_t kBeyond = 5;
/// Numbers of keys, doors and plates are below this.
constexpr std::int64_t kDoorNumbers = 32;
/// A timed segment is solid and open for at most this many ticks each.
constexpr std::int64_t kLongestTime = 3600;

/// The words in the order of `Word`.
constexpr std::array<std::string_view, 8> kWords{"oneway", "up",   "hazard", "checkpoint",
                                                 "key",    "door", "plate",  "timed"};

std::optional<Word> wordOf(const std::string& text) {
  const auto found = std::find(kWords.begin(), kWords.end(), text);
  if (found == kWords.end()) return std::nullopt;
  return static_cast<Word>(found - kWords.begin());
}

/// Whether the numbers are those that may follow the word; -1 stands for none.
bool areNumbersOf(Word word, std::size_t edges, std::int64_t first, std::int64_t second) {
  switch (word) {
    case Word::kUp:
      return first >= 0 && first < static_cast<std::int64_t>(edges) && second == -1;
    case Word::kKey:
    case Word::kDoor:
    case Word::kPlate:
      return first >= 0 && first < kDoorNumbers && second == -1;
    case Word::kTimed:
      return std::min(first, second) > 0 && std::max(first, second) <= kLongestTime;
    case Word::kOneway:
    case Word::kHazard:
    case Word::kCheckpoint:
      return first == -1 && second == -1;
  }
  return false;
}

/// The edge moved outwards by kBeyond subunits and shortened by as much at both ends, so that it lies in the adjacent
/// face even if that face has acute corners.
Segment beyond(const Segment& edge) {
  const RealVec a = toReal(edge.a);
  const RealVec b = toReal(edge.b);
  const long double length = distance(a, b);
  const RealVec along{(b.x - a.x) * kBeyond / length, (b.y - a.y) * kBeyond / length};
  const auto rounded = [](long double x, long double y) { return Vec{std::llround(x), std::llround(y)}; };
  return {rounded(a.x + along.x + along.y, a.y + along.y - along.x),
          rounded(b.x - along.x + along.y, b.y - along.y - along.x)};
}

}  // namespace

/// Builds a TraceMap from a header and checks the header.
class TraceMapBuilder {
 public:
  TraceMapBuilder(const TraceHeader& header, TraceReport& report) : header_(header), report_(report) {}

  std::optional<TraceMap> make() {
    map_.shape_ = header_.shape;
    if (!isStrictlyConvex(header_.shape)) return refuse("shape is not strictly convex and counter-clockwise");
    if (!(header_.solid == "PLANE" ? makePlane() : makeSolid())) return std::nullopt;
    for (const TraceElement& element : header_.elements)
      if (!addElement(element)) return std::nullopt;
    return std::move(map_);
  }

 private:
  std::nullopt_t refuse(const std::string& what) {
    report_.violate("header", what);
    return std::nullopt;
  }

  bool makePlane() {
    const bool bare = header_.faces.size() == 1 && header_.faces[0].polygon.empty() && header_.faces[0].warps.empty();
    if (!bare) report_.violate("header", "a plane has one face, without polygon and warps");
    if (bare) makeFaces();
    return bare;
  }

  bool makeSolid() {
    const SolidNumbers* solid = findSolid(header_.solid);
    if (solid == nullptr || header_.faces.size() != solid->faces) {
      report_.violate("header", header_.solid + " with " + std::to_string(header_.faces.size()) + " faces");
      return false;
    }
    FaceChecks checks(*solid, header_, report_);
    if (!checks.areFacesRegular() || !checks.areWarpsGlued()) return false;
    checks.checkCornersOfSolid();
    checks.checkLines();
    makeFaces();
    for (std::size_t face = 0; face < map_.faces_.size(); ++face) makeWarps(checks, face);
    return true;
  }

  void makeFaces() {
    for (const TraceFace& face : header_.faces) {
      MapFace& made = map_.faces_.emplace_back();
      made.edges = face.polygon.size();
      for (const Segment& line : face.lines) made.lines.push_back({line, boxOf(line)});
    }
  }

  bool addElement(const TraceElement& element) {
    const auto isBelow = [](std::int64_t index, std::size_t count) {
      return index >= 0 && index < static_cast<std::int64_t>(count);
    };
    if (!isBelow(element.face, map_.faces_.size())) return failElement("is in no face");
    MapFace& face = map_.faces_[static_cast<std::size_t>(element.face)];
    if (!isBelow(element.line, face.lines.size())) return failElement("has no line");
    MapLine& line = face.lines[static_cast<std::size_t>(element.line)];
    if (line.element >= 0) return failElement("has the line of another one");
    const std::optional<Word> word = wordOf(element.word);
    if (!word) return failElement("has an unknown word");
    if (!areNumbersOf(*word, face.edges, element.k, element.k2)) return failElement("has a wrong number");
    if (*word == Word::kOneway && line.segment.a == line.segment.b) return failElement("has no sides");
    line.element = static_cast<std::int64_t>(map_.elements_.size());
    map_.elements_.push_back({element.face, line.segment, *word, element.k, element.k2});
    return true;
  }

  bool failElement(const std::string& what) {
    report_.violate("header", "element " + std::to_string(map_.elements_.size()) + " " + what);
    return false;
  }

  void makeWarps(const FaceChecks& checks, std::size_t face) {
    for (std::size_t index = 0; index < header_.faces[face].warps.size(); ++index) {
      const TraceWarp& warp = header_.faces[face].warps[index];
      map_.faces_[face].warps.push_back({warp.from, boxOf(warp.from).joined(boxOf(beyond(warp.from))),
                                         beyond(warp.from), static_cast<std::size_t>(warp.to),
                                         checks.reverseOf(face, index), checks.motionOf(face, index)});
    }
  }

  const TraceHeader& header_;
  TraceReport& report_;
  TraceMap map_;
};

std::optional<TraceMap> TraceMap::make(const TraceHeader& header, TraceReport& report) {
  return TraceMapBuilder(header, report).make();
}

}  // namespace platon::oracle
