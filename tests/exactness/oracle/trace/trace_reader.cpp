#include "tests/exactness/oracle/trace/trace_reader.h"

#include <algorithm>
#include <array>
#include <span>

#include "tests/exactness/oracle/trace/json_reader.h"

namespace platon::oracle {
namespace {

constexpr std::int64_t kSubunitsPerUnit = 1024;
constexpr std::size_t kHashDigits = 16;

constexpr std::array<std::string_view, 3> kWarpKeys{"from", "to", "onto"};
constexpr std::array<std::string_view, 4> kFaceKeys{"face", "polygon", "lines", "warps"};
constexpr std::array<std::string_view, 7> kInstanceKeys{"id", "face", "x", "y", "angle", "via", "shape"};
constexpr std::array<std::string_view, 2> kPlayerKeys{"id", "legs"};
constexpr std::array<std::string_view, 5> kElementKeys{"face", "line", "word", "k", "k2"};
constexpr std::array<std::string_view, 5> kHeaderKeys{"solid", "subunits", "shape", "elements", "faces"};
constexpr std::array<std::string_view, 4> kTickKeys{"tick", "hash", "open", "players"};
constexpr std::size_t kNumberKey = 3;
constexpr std::size_t kViaKey = 5;
constexpr std::size_t kShapeKey = 6;

/// Checks the keys of one object: each at most once, none unknown, and no required key missing.
class Keys {
 public:
  /// The first `required` names are required.
  Keys(const JsonReader& reader, std::span<const std::string_view> names, std::size_t required)
      : reader_(reader), names_(names), required_(required) {}
  Keys(const JsonReader& reader, std::span<const std::string_view> names) : Keys(reader, names, names.size()) {}

  /// Index of `key` in the names.
  std::size_t take(std::string_view key) {
    const auto name = std::find(names_.begin(), names_.end(), key);
    if (name == names_.end()) reader_.fail("unknown key \"" + std::string(key) + "\"");
    const auto index = static_cast<std::size_t>(name - names_.begin());
    if (has(index)) reader_.fail("key \"" + std::string(key) + "\" occurs twice");
    seen_ |= 1u << index;
    return index;
  }
  bool has(std::size_t index) const { return (seen_ >> index & 1u) != 0; }
  void finish() const {
    for (std::size_t i = 0; i < required_; ++i)
      if (!has(i)) reader_.fail("key \"" + std::string(names_[i]) + "\" is missing");
  }

 private:
  const JsonReader& reader_;
  std::span<const std::string_view> names_;
  std::size_t required_;
  unsigned seen_ = 0;
};

std::int64_t readCoordinate(JsonReader& reader) {
  const std::int64_t value = reader.integer();
  if (value <= -kCoordinateLimit || value >= kCoordinateLimit) reader.fail("coordinate of 2^29 or more");
  return value;
}

/// An array of exactly `Count` values of one kind.
template <std::size_t Count, typename Read>
std::array<std::int64_t, Count> readTuple(JsonReader& reader, Read read) {
  std::array<std::int64_t, Count> values{};
  std::size_t count = 0;
  reader.array([&] {
    if (count == Count) reader.fail("array longer than " + std::to_string(Count));
    values[count++] = read(reader);
  });
  if (count != Count) reader.fail("array shorter than " + std::to_string(Count));
  return values;
}

Segment readSegment(JsonReader& reader) {
  const auto [x0, y0, x1, y1] = readTuple<4>(reader, readCoordinate);
  return {{x0, y0}, {x1, y1}};
}

Polygon readPolygon(JsonReader& reader) {
  Polygon polygon;
  reader.array([&] {
    const auto [x, y] = readTuple<2>(reader, readCoordinate);
    polygon.push_back({x, y});
  });
  return polygon;
}

TraceWarp readWarp(JsonReader& reader) {
  TraceWarp warp;
  Keys keys(reader, kWarpKeys);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        warp.from = readSegment(reader);
        break;
      case 1:
        warp.to = reader.integer();
        break;
      default:
        warp.onto = readSegment(reader);
    }
  });
  keys.finish();
  return warp;
}

TraceFace readFace(JsonReader& reader, std::int64_t index) {
  TraceFace face;
  Keys keys(reader, kFaceKeys);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        if (reader.integer() != index) reader.fail("faces are not numbered in order");
        break;
      case 1:
        face.polygon = readPolygon(reader);
        break;
      case 2:
        reader.array([&] { face.lines.push_back(readSegment(reader)); });
        break;
      default:
        reader.array([&] { face.warps.push_back(readWarp(reader)); });
    }
  });
  keys.finish();
  return face;
}

TraceElement readElement(JsonReader& reader) {
  TraceElement element;
  Keys keys(reader, kElementKeys, kNumberKey);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        element.face = reader.integer();
        break;
      case 1:
        element.line = reader.integer();
        break;
      case 2:
        element.word = reader.string();
        break;
      default:
        std::int64_t& number = key == "k" ? element.k : element.k2;
        number = reader.integer();
        if (number < 0) reader.fail("negative number of an element");
    }
  });
  keys.finish();
  return element;
}

TraceInstance readInstance(JsonReader& reader) {
  TraceInstance instance;
  Keys keys(reader, kInstanceKeys, kViaKey);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        instance.id = reader.integer();
        break;
      case 1:
        instance.face = reader.integer();
        break;
      case 2:
        instance.position.x = readCoordinate(reader);
        break;
      case 3:
        instance.position.y = readCoordinate(reader);
        break;
      case 4:
        instance.angle = reader.integer();
        break;
      case kViaKey: {
        const auto [parent, warp] = readTuple<2>(reader, [](JsonReader& element) { return element.integer(); });
        instance.parent = parent;
        instance.warp = warp;
        break;
      }
      default:
        instance.shape = readPolygon(reader);
    }
  });
  keys.finish();
  instance.home = !keys.has(kViaKey);
  if (keys.has(kShapeKey) && instance.shape.empty()) reader.fail("empty shape");
  return instance;
}

TracePlayer readPlayer(JsonReader& reader) {
  TracePlayer player;
  Keys keys(reader, kPlayerKeys);
  reader.object([&](std::string_view key) {
    if (keys.take(key) == 0) {
      player.id = reader.integer();
      return;
    }
    reader.array([&] {
      TraceLeg& leg = player.legs.emplace_back();
      reader.array([&] { leg.push_back(readInstance(reader)); });
    });
  });
  keys.finish();
  return player;
}

std::string readHash(JsonReader& reader) {
  const std::string_view hash = reader.string();
  if (hash.size() != kHashDigits || hash.find_first_not_of("0123456789abcdef") != std::string_view::npos)
    reader.fail("hash must have 16 hexadecimal digits");
  return std::string(hash);
}

}  // namespace

TraceHeader readTraceHeader(std::string_view line) {
  TraceHeader header;
  JsonReader reader(line);
  Keys keys(reader, kHeaderKeys);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        header.solid = reader.string();
        break;
      case 1:
        if (reader.integer() != kSubunitsPerUnit) reader.fail("subunits must be 1024");
        break;
      case 2:
        header.shape = readPolygon(reader);
        break;
      case 3:
        reader.array([&] { header.elements.push_back(readElement(reader)); });
        break;
      default:
        reader.array([&] { header.faces.push_back(readFace(reader, static_cast<std::int64_t>(header.faces.size()))); });
    }
  });
  keys.finish();
  reader.end();
  return header;
}

TraceTick readTraceTick(std::string_view line) {
  TraceTick tick;
  JsonReader reader(line);
  Keys keys(reader, kTickKeys);
  reader.object([&](std::string_view key) {
    switch (keys.take(key)) {
      case 0:
        tick.tick = reader.integer();
        break;
      case 1:
        tick.hash = readHash(reader);
        break;
      case 2:
        reader.array([&] { tick.open.push_back(reader.integer()); });
        break;
      default:
        reader.array([&] { tick.players.push_back(readPlayer(reader)); });
    }
  });
  keys.finish();
  reader.end();
  return tick;
}

}  // namespace platon::oracle
