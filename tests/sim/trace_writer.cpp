#include "tests/sim/trace_writer.h"

#include <array>
#include <charconv>
#include <utility>

#include "tests/sim/hex_digits.h"

namespace platon::sim {
void TraceWriter::put(std::int64_t number) {
  std::array<char, 24> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  line_.append(text.data(), end);
}

void TraceWriter::put(Point point) {
  put("[");
  put(std::int64_t{point.x});
  put(",");
  put(std::int64_t{point.y});
  put("]");
}

void TraceWriter::put(const Segment& line) {
  put("[");
  for (const std::int32_t coordinate : {line.a.x, line.a.y, line.b.x}) {
    put(std::int64_t{coordinate});
    put(",");
  }
  put(std::int64_t{line.b.y});
  put("]");
}

void TraceWriter::putShape(const Convex& shape) {
  const char* separator = "[";
  for (const Point vertex : shape.vertices()) {
    put(std::exchange(separator, ","));
    put(vertex);
  }
  put("]");
}

void TraceWriter::header(const World& world, const Convex& shape, const Level* level) {
  shape_ = shape;
  put("{\"solid\":\"");
  put(level != nullptr ? nameOf(level->solid) : "PLANE");
  put("\",\"subunits\":1024,\"shape\":");
  putShape(shape);
  put(",\"faces\":");
  const char* separator = "[";
  const auto polygon = level != nullptr ? facePolygon(level->solid, level->faceSize) : std::vector<Point>();
  for (const auto& part : world.geometry().parts) {
    put(std::exchange(separator, ","));
    putFace(*part, polygon);
  }
  put("],\"elements\":[");
  if (level != nullptr) elements_ = level->elements;
  separator = "";
  for (const Element& element : elements_) {
    put(std::exchange(separator, ","));
    put(element);
  }
  put("]}");
  flushLine();
}

void TraceWriter::put(const Element& element) {
  put("{\"face\":");
  put(std::int64_t{element.face});
  put(",\"line\":");
  put(std::int64_t{element.segment});
  put(",\"word\":\"");
  put(wordOf(element.kind));
  put("\"");
  if (numbersOf(element.kind) > 0) {
    put(",\"k\":");
    put(std::int64_t{element.number});
  }
  if (numbersOf(element.kind) > 1) {
    put(",\"k2\":");
    put(std::int64_t{element.openTicks});
  }
  put("}");
}

void TraceWriter::putFace(const MapGeometry& part, const std::vector<Point>& polygon) {
  put("{\"face\":");
  put(std::int64_t{part.id});
  put(",\"polygon\":[");
  const char* separator = "";
  for (const Point corner : polygon) {
    put(std::exchange(separator, ","));
    put(corner);
  }
  put("],\"lines\":[");
  separator = "";
  for (std::uint32_t i = 0; i < part.segmentOfWarp(0); ++i) {
    put(std::exchange(separator, ","));
    put(part.segments[i]);
  }
  put("],\"warps\":[");
  separator = "";
  for (const Warp& warp : part.warps) {
    put(std::exchange(separator, ","));
    put("{\"from\":");
    put(warp.from);
    put(",\"to\":");
    put(std::int64_t{warp.target});
    put(",\"onto\":");
    put(warp.onto);
    put("}");
  }
  put("]}");
}

const std::string& TraceWriter::rotatedShape(Angle angle) {
  const auto found = shapes_.find(angle.centidegrees());
  if (found != shapes_.end()) return found->second;
  std::string outer;
  outer.swap(line_);
  if (const auto turned = shape_->turned(angle); turned && !(*turned == *shape_)) {
    put(",\"shape\":");
    putShape(*turned);
  }
  outer.swap(line_);
  return shapes_.emplace(angle.centidegrees(), std::move(outer)).first->second;
}

void TraceWriter::put(const InstanceView& instance) {
  put("{\"id\":");
  put(std::int64_t{instance.id});
  put(",\"face\":");
  put(std::int64_t{instance.part});
  put(",\"x\":");
  put(std::int64_t{instance.position.x});
  put(",\"y\":");
  put(std::int64_t{instance.position.y});
  put(",\"angle\":");
  put(std::int64_t{instance.angle.centidegrees()});
  if (instance.hasParent) {
    put(",\"via\":[");
    put(std::int64_t{instance.parent});
    put(",");
    put(std::int64_t{instance.warp});
    put("]");
  }
  put(rotatedShape(instance.angle));
  put("}");
}

void TraceWriter::leg(std::uint32_t entity, std::span<const InstanceView> instances) {
  std::string& legs = legs_[entity];
  line_.swap(legs);
  put(line_.empty() ? "[" : ",[");
  const char* separator = "";
  for (const InstanceView& instance : instances) {
    put(std::exchange(separator, ","));
    put(instance);
  }
  put("]");
  line_.swap(legs);
}

void TraceWriter::putOpen(OpenElements open) {
  put("[");
  const char* separator = "";
  for (std::size_t id = 0; id < elements_.size(); ++id) {
    if (!open.has(elements_[id])) continue;
    put(std::exchange(separator, ","));
    put(static_cast<std::int64_t>(id));
  }
  put("]");
}

void TraceWriter::tick(std::uint64_t number, std::uint64_t hash, OpenElements open) {
  put("{\"tick\":");
  put(static_cast<std::int64_t>(number));
  put(",\"hash\":\"");
  put(hexDigits(hash));
  put("\",\"open\":");
  putOpen(open);
  put(",\"players\":[");
  const char* separator = "";
  for (auto& [entity, legs] : legs_) {
    if (legs.empty()) continue;
    put(std::exchange(separator, ","));
    put("{\"id\":");
    put(std::int64_t{entity});
    put(",\"legs\":[");
    put(legs);
    put("]}");
    legs.clear();
  }
  put("]}");
  flushLine();
}

void TraceWriter::flushLine() {
  line_ += '\n';
  file_.write(line_);
  line_.clear();
}

}  // namespace platon::sim
