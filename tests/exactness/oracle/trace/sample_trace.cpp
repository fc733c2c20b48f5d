#include "tests/exactness/oracle/trace/sample_trace.h"

#include <algorithm>
#include <cmath>

#include "tests/exactness/oracle/trace/solid_model.h"
#include "tests/exactness/oracle/trace/trace_checker.h"

namespace platon::oracle {
namespace {

constexpr std::int64_t kSubunitsPerUnit = 1024;

/// Number of quarter turns from direction `from` to direction `onto`.
std::int64_t quarterTurns(Vec from, Vec onto) {
  std::int64_t turns = 0;
  for (; cross(from, onto) != 0 || dot(from, onto) < 0; ++turns) from = {-from.y, from.x};
  return turns;
}

Vec turned(Vec v, std::int64_t quarters) {
  for (std::int64_t i = 0; i < quarters; ++i) v = {-v.y, v.x};
  return v;
}

TraceInstance homeAt(std::int64_t x) {
  TraceInstance home;
  home.id = 7;
  home.position = {x, 300};
  return home;
}

/// The warp of edge 1, the right edge of a face of the hexahedron.
constexpr std::size_t kRightWarp = 1;

std::string bracketed(const std::string& text) { return std::string("[").append(text).append("]"); }

template <typename Values, typename Format>
std::string list(const Values& values, Format format) {
  std::string text;
  for (const auto& value : values) text.append(text.empty() ? "" : ",").append(format(value));
  return bracketed(text);
}

std::string toJson(const Segment& segment) {
  std::string text = toText(segment);
  std::replace(text.begin(), text.end(), ' ', ',');
  return bracketed(text);
}

std::string toJson(const Polygon& polygon) {
  return list(polygon, [](Vec v) { return bracketed(std::to_string(v.x).append(",").append(std::to_string(v.y))); });
}

/// "key":value, followed by a comma.
std::string field(const std::string& key, const std::string& value) {
  return std::string("\"").append(key).append("\":").append(value).append(",");
}

std::string field(const std::string& key, std::int64_t value) { return field(key, std::to_string(value)); }

/// An object of fields, without the last comma.
std::string object(std::string fields) {
  fields.back() = '}';
  return std::string("{").append(fields);
}

std::string toJson(const TraceWarp& warp) {
  return object(field("from", toJson(warp.from)) + field("to", warp.to) + field("onto", toJson(warp.onto)));
}

std::string toJson(const TraceInstance& instance) {
  std::string fields = field("id", instance.id) + field("face", instance.face) + field("x", instance.position.x) +
                       field("y", instance.position.y) + field("angle", instance.angle);
  const std::vector<std::int64_t> via{instance.parent, instance.warp};
  if (!instance.home) fields += field("via", list(via, [](std::int64_t value) { return std::to_string(value); }));
  if (!instance.shape.empty()) fields += field("shape", toJson(instance.shape));
  return object(fields);
}

std::string toJson(const TracePlayer& player) {
  const auto leg = [](const TraceLeg& instances) {
    return list(instances, [](const TraceInstance& instance) { return toJson(instance); });
  };
  return object(field("id", player.id) + field("legs", list(player.legs, leg)));
}

std::string toJson(const TraceElement& element) {
  std::string fields = field("face", element.face) + field("line", element.line) +
                       field("word", std::string("\"").append(element.word).append("\""));
  if (element.k >= 0) fields += field("k", element.k);
  if (element.k2 >= 0) fields += field("k2", element.k2);
  return object(fields);
}

void addWarps(TraceHeader& header, const std::vector<std::vector<int>>& faces, std::size_t face) {
  const std::size_t corners = faces[face].size();
  const Polygon& polygon = header.faces[face].polygon;
  for (std::size_t edge = 0; edge < corners; ++edge)
    for (std::size_t to = 0; to < faces.size(); ++to)
      for (std::size_t other = 0; other < corners; ++other) {
        const bool same = faces[to][other] == faces[face][(edge + 1) % corners] &&
                          faces[to][(other + 1) % corners] == faces[face][edge];
        if (!same) continue;
        const Polygon& target = header.faces[to].polygon;
        header.faces[face].warps.push_back({{polygon[edge], polygon[(edge + 1) % corners]},
                                            static_cast<std::int64_t>(to),
                                            {target[(other + 1) % corners], target[other]}});
      }
}

}  // namespace

TraceHeader makeHeader(const std::string& solid, const std::vector<std::vector<int>>& faces, std::int64_t size) {
  TraceHeader header{solid, {{-1000, -800}, {1000, -800}, {0, 1200}}, std::vector<TraceFace>(faces.size())};
  for (TraceFace& face : header.faces) {
    const std::size_t corners = faces.front().size();
    for (std::size_t i = 0; i < corners; ++i) {
      const RealVec corner = idealCorner(corners, static_cast<long double>(size * kSubunitsPerUnit), i);
      face.polygon.push_back({std::llround(corner.x), std::llround(corner.y)});
      face.lines.push_back({face.polygon[i], face.polygon[i]});
    }
  }
  for (std::size_t face = 0; face < faces.size(); ++face) addWarps(header, faces, face);
  return header;
}

TraceInstance behindWarp(const TraceHeader& header, const TraceInstance& parent, std::size_t warp, std::int64_t id) {
  const TraceWarp& through = header.faces[static_cast<std::size_t>(parent.face)].warps[warp];
  const std::int64_t quarters = quarterTurns(through.from.b - through.from.a, through.onto.b - through.onto.a);
  TraceInstance instance{id,
                         through.to,
                         through.onto.a + turned(parent.position - through.from.a, quarters),
                         normalizedAngle(parent.angle + quarters * kTurn / 4),
                         false,
                         parent.id,
                         static_cast<std::int64_t>(warp),
                         {}};
  for (const Vec corner : header.shape) instance.shape.push_back(turned(corner, instance.angle * 4 / kTurn));
  if (instance.shape == header.shape) instance.shape.clear();
  return instance;
}

SampleTrace sampleTrace() {
  SampleTrace sample{
      makeHeader("HEXAHEDRON", {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
                 400),
      {}};
  const TraceHeader& header = sample.header;
  const auto pair = [&](std::int64_t x) -> TraceLeg {
    return {homeAt(x), behindWarp(header, homeAt(x), kRightWarp, 8)};
  };
  const auto rehomed = [&](std::int64_t x) {
    TraceLeg leg = pair(x);
    leg[0].home = false;
    leg[0].parent = leg[1].id;
    const std::vector<TraceWarp>& warps = header.faces[static_cast<std::size_t>(leg[1].face)].warps;
    while (warps[static_cast<std::size_t>(leg[0].warp)].to != leg[0].face) ++leg[0].warp;
    leg[1].home = true;
    leg[1].parent = leg[1].warp = 0;
    return leg;
  };
  const TraceLeg start{homeAt(1000)};
  const std::int64_t reaching = kSampleHalf - 500;
  const std::int64_t over = kSampleHalf + 500;
  const TraceLeg left{rehomed(kSampleHalf + 3000)[1]};
  const std::vector<std::vector<TraceLeg>> ticks{{start, start},
                                                 {start, {homeAt(90000)}, pair(reaching)},
                                                 {pair(reaching), pair(over), rehomed(over)},
                                                 {rehomed(over), rehomed(kSampleHalf + 3000), left}};
  for (std::size_t tick = 0; tick < ticks.size(); ++tick)
    sample.ticks.push_back({static_cast<std::int64_t>(tick) + 1, "0123456789abcdef", {{0, ticks[tick]}}});
  return sample;
}

std::string toJson(const TraceHeader& header) {
  std::int64_t index = 0;
  const auto line = [](const Segment& segment) { return toJson(segment); };
  const auto warp = [](const TraceWarp& value) { return toJson(value); };
  const auto element = [](const TraceElement& value) { return toJson(value); };
  const auto face = [&](const TraceFace& value) {
    return object(field("face", index++) + field("polygon", toJson(value.polygon)) +
                  field("lines", list(value.lines, line)) + field("warps", list(value.warps, warp)));
  };
  return object(field("solid", std::string("\"").append(header.solid).append("\"")) + field("subunits", 1024) +
                field("shape", toJson(header.shape)) + field("faces", list(header.faces, face)) +
                field("elements", list(header.elements, element)));
}

std::string toJson(const TraceTick& tick) {
  const auto player = [](const TracePlayer& value) { return toJson(value); };
  return object(field("tick", tick.tick) + field("hash", std::string("\"").append(tick.hash).append("\"")) +
                field("open", list(tick.open, [](std::int64_t door) { return std::to_string(door); })) +
                field("players", list(tick.players, player)));
}

std::set<std::string> violatedRules(const std::vector<std::string>& lines) {
  TraceChecker checker;
  for (const std::string& line : lines)
    if (!checker.checkLine(line)) break;
  checker.finish();
  return checker.report().violatedRules();
}

std::set<std::string> violatedRules(const SampleTrace& trace) {
  std::vector<std::string> lines{toJson(trace.header)};
  for (const TraceTick& tick : trace.ticks) lines.push_back(toJson(tick));
  return violatedRules(lines);
}

}  // namespace platon::oracle
