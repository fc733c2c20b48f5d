#include "tests/exactness/reference/terrain.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tests/exactness/oracle/random_source.h"

namespace platon::reference {
namespace {

using oracle::RandomSource;
using oracle::Vec;

constexpr std::int64_t kUnit = kTerrainSubunits;
constexpr std::int64_t kLoose = 2;  // subunits by which the ends of a loose joint miss each other along each axis

std::int64_t product(Vec a, Vec b) { return static_cast<std::int64_t>(oracle::dot(a, b)); }
Vec left(Vec v) { return {-v.y, v.x}; }

std::int64_t rootOf(std::int64_t square) {
  std::int64_t low = 0;
  for (std::int64_t bit = std::int64_t{1} << 31; bit > 0; bit /= 2) {
    if ((low + bit) * (low + bit) <= square) low += bit;
  }
  return low;
}

/// A vector in the direction of `v` with about this length.
Vec withLength(Vec v, std::int64_t length) {
  const std::int64_t size = rootOf(product(v, v));
  return {v.x * length / size, v.y * length / size};
}

Vec supportOf(const oracle::Polygon& shape, Vec direction) {
  return *std::max_element(shape.begin(), shape.end(),
                           [&](Vec a, Vec b) { return product(a, direction) < product(b, direction); });
}

/// Length of the shape along a direction.
std::int64_t extentOf(const oracle::Polygon& shape, Vec direction) {
  return product(supportOf(shape, direction) - supportOf(shape, -direction), direction) /
         rootOf(product(direction, direction));
}

struct Kind {
  const char* name;
  oracle::Polygon vertices;      // in thousandths of the radius
  std::int64_t percentOverEnds;  // largest slope (relative to the push) at which no end that protrudes stops the shape
};

const std::array<Kind, 4>& kinds() {
  static const std::array<Kind, 4> all = {{
      {"octagon",
       {{383, -924}, {924, -383}, {924, 383}, {383, 924}, {-383, 924}, {-924, 383}, {-924, -383}, {-383, -924}},
       75},
      {"hexagon", {{1000, 0}, {500, 866}, {-500, 866}, {-1000, 0}, {-500, -866}, {500, -866}}, 40},
      {"box", {{-707, -707}, {707, -707}, {707, 707}, {-707, 707}}, 0},
      {"triangle", {{0, 1000}, {-866, -500}, {866, -500}}, 0},
  }};
  return all;
}

class TerrainMaker {
 public:
  TerrainMaker(std::uint64_t seed, std::int64_t ticks) : random_(seed), ticks_(ticks) {}

  Terrain make() {
    do {
      build();
    } while (!startIsFree());
    return {kind_->name, std::move(scene_)};
  }

 private:
  void build() {
    scene_ = {};
    leaves_ = {};
    chooseKind();
    makeShape();
    makeVelocity();
    const std::int64_t distance = ticks_ * product(scene_.velocity, scene_.velocity);
    const bool walled = random_.oneIn(6);
    const std::int64_t goal = walled ? distance * random_.between(20, 60) / 100 : distance;
    while (product(leaves_, scene_.velocity) < goal) addRun();
    if (walled) addWall();
    shuffle(scene_.lines);
  }

  // Also of a body that is a little larger.
  bool startIsFree() const {
    const auto area = oracle::OpenArea::placed(scene_.shape, scene_.start).inset(-8);
    return std::none_of(scene_.lines.begin(), scene_.lines.end(),
                        [&](const oracle::Segment& line) { return area.intersects(line); });
  }

  void shuffle(std::vector<oracle::Segment>& lines) {
    for (std::size_t i = lines.size(); i > 1; --i) std::swap(lines[i - 1], lines[random_.below(i)]);
  }

  void chooseKind() {
    constexpr std::array<std::size_t, 20> choices = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 3};
    kind_ = &kinds()[choices[random_.below(choices.size())]];
  }

  void makeShape() {
    const std::int64_t radius = random_.between(6 * kUnit, 12 * kUnit);
    const bool turned = random_.oneIn(2);
    const bool uneven = random_.oneIn(2);
    do {
      const Vec turn = turned ? Vec{random_.between(1, 1000), random_.between(-1000, 1000)} : Vec{1, 0};
      const std::int64_t size = 1000 * rootOf(product(turn, turn));
      scene_.shape.clear();
      for (const Vec v : kind_->vertices) {
        const Vec at = {(v.x * turn.x - v.y * turn.y) * radius / size, (v.x * turn.y + v.y * turn.x) * radius / size};
        scene_.shape.push_back(at + random_.vector(uneven ? radius / 16 : 1));
      }
    } while (!oracle::isStrictlyConvex(scene_.shape));
  }

  void makeVelocity() {
    const std::int64_t speed = random_.between(300, random_.oneIn(4) ? 4000 : 1500);
    Vec heading;
    while (heading == Vec{}) heading = random_.vector(random_.oneIn(8) ? 1 : 1000);
    scene_.velocity = withLength(heading, speed);
  }

  // A direction beside the velocity, to the left of it if side_ is 1.
  Vec slope() {
    const Vec v = scene_.velocity;
    if (random_.oneIn(6)) {
      const std::size_t i = random_.below(scene_.shape.size());
      const Vec edge = scene_.shape[(i + 1) % scene_.shape.size()] - scene_.shape[i];
      const Vec along = product(edge, v) < 0 ? -edge : edge;
      const auto rise = std::abs(static_cast<std::int64_t>(oracle::cross(v, along)));
      if (side_ * oracle::cross(v, along) > 0 && rise < 2 * product(v, along)) return along;
    }
    const std::int64_t usual = kind_->percentOverEnds > 0 ? kind_->percentOverEnds : 120;
    const std::int64_t percent = random_.between(0, random_.oneIn(8) ? 250 : usual);
    return 100 * v + side_ * percent * left(v);
  }

  bool isGentle(Vec along) const {
    const Vec v = scene_.velocity;
    return 100 * std::abs(static_cast<std::int64_t>(oracle::cross(v, along)) / 100) <=
           kind_->percentOverEnds * (product(v, along) / 100);
  }

  // Where the next segment starts: at a loose joint, up to 2 subunits beside the end of the last one. Joints at which
  // an end can stop the body are seldom loose, and the longer the chain, the fewer.
  Vec jointAt(Vec end, Vec along, Vec next) {
    const bool harmless = isGentle(along) && isGentle(next);
    const bool loose = random_.oneIn(harmless ? 2 : 60 + ticks_ / 100);
    return loose ? end + random_.vector(kLoose) : end;
  }

  void addRun() {
    const Vec v = scene_.velocity;
    const std::int64_t last = std::exchange(side_, random_.oneIn(3) ? -1 : 1);
    // A body that is turned to the other side must have passed the end of the last run, or it would be stuck there.
    const std::int64_t shortest = side_ == last ? kUnit : extentOf(scene_.shape, v);
    const std::int64_t flight = shortest + random_.between(0, random_.oneIn(4) ? 24 * kUnit : 4 * kUnit);
    Vec along = withLength(slope(), length());
    const Vec meets = leaves_ + withLength(v, flight) + supportOf(scene_.shape, -side_ * left(along));
    Vec from = meets - withLength(along, random_.between(1, flight));
    Vec to = meets + along;
    addLine(from, to);
    for (std::int64_t left = random_.between(0, 8); left > 0; --left) {
      const Vec next = withLength(slope(), length());
      from = jointAt(to, along, next);
      to = from + next;
      along = next;
      addLine(from, to);
    }
    if (random_.oneIn(std::max<std::int64_t>(60, ticks_ / 50))) addOverhang(from, to);  // it often stops the body
    lastEnd_ = to;
    leaves_ = to - supportOf(scene_.shape, -side_ * left(v));
  }

  void addLine(Vec from, Vec to) {
    scene_.lines.push_back(random_.oneIn(2) ? oracle::Segment{from, to} : oracle::Segment{to, from});
    if (random_.oneIn(12) && isGentle(to - from)) addPoint(from, to);
  }

  // A point that lies on a slope or slightly above it.
  void addPoint(Vec from, Vec to) {
    const Vec on = from + withLength(to - from, random_.between(1, extentOf({from, to}, to - from)));
    const Vec point = on + withLength(side_ * left(to - from), random_.between(0, random_.oneIn(2) ? 20 : 300));
    scene_.lines.push_back({point, point});
  }

  // A segment beyond the body, some of it so close that the body scrapes along it.
  void addOverhang(Vec from, Vec to) {
    const Vec up = side_ * left(to - from);
    const std::int64_t width = extentOf(scene_.shape, up);
    const auto above = [&](Vec at) { return at + withLength(up, width * random_.between(101, 180) / 100); };
    scene_.lines.push_back({above(from), above(to)});
  }

  // A steep end of the last run, which leads back.
  void addWall() {
    const Vec v = scene_.velocity;
    const Vec back = 100 * side_ * left(v) - random_.between(1, 100) * v;
    scene_.lines.push_back({lastEnd_, lastEnd_ + withLength(back, 40 * kUnit)});
  }

  std::int64_t length() { return random_.between(2 * kUnit, random_.oneIn(3) ? 60 * kUnit : 20 * kUnit); }

  RandomSource random_;
  std::int64_t ticks_;
  const Kind* kind_ = nullptr;
  ExactScene scene_;
  std::int64_t side_ = 1;  // 1: the run is to the right of the velocity and leads the body to the left; -1: the reverse
  Vec lastEnd_;            // the last point of the last run
  Vec leaves_;             // where the body leaves it
};

std::string lineOf(const char* word, const std::vector<Vec>& points) {
  std::string text = word;
  for (const Vec v : points) text += " " + std::to_string(v.x) + " " + std::to_string(v.y);
  return text + "\n";
}

}  // namespace

Terrain randomTerrain(std::uint64_t seed, std::int64_t ticks) { return TerrainMaker(seed, ticks).make(); }

std::string toText(const ExactScene& scene) {
  std::string text = lineOf("shape", scene.shape);
  for (const oracle::Segment& line : scene.lines) text += lineOf("line", {line.a, line.b});
  return text + lineOf("entity", {scene.start}) + lineOf("velocity", {scene.velocity});
}

}  // namespace platon::reference
