#include "tests/support/element_level.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string_view>
#include <vector>

namespace platon {
namespace {

struct Solid {
  std::string_view name;
  int faces;
  int edges;
};

constexpr std::array<Solid, 5> kSolids = {{{"TETRAHEDRON", 4, 3},
                                           {"HEXAHEDRON", 6, 4},
                                           {"OCTAHEDRON", 8, 3},
                                           {"DODECAHEDRON", 12, 5},
                                           {"ICOSAHEDRON", 20, 3}}};
constexpr int kFaceSize = 300;
constexpr int kLinesOfFace = 12;
constexpr double kFree = 14;  // radius of a place where nothing may block, in units

struct WordedLine {
  int x0, y0, x1, y1;
  std::string word;

  bool canBlock() const { return word != "checkpoint" && !word.starts_with("key"); }
  double distanceTo(double x, double y) const {
    const double dx = x1 - x0;
    const double dy = y1 - y0;
    const double length = dx * dx + dy * dy;
    const double along = length == 0 ? 0 : std::clamp(((x - x0) * dx + (y - y0) * dy) / length, 0.0, 1.0);
    return std::hypot(x0 + along * dx - x, y0 + along * dy - y);
  }
};

class Generator {
 public:
  Generator(const Solid& solid, std::uint64_t seed)
      : solid_(solid), random_(seed), inradius_(static_cast<int>(kFaceSize / 2 / std::tan(3.14159265 / solid.edges))) {}

  std::string text() {
    std::string text = std::string(solid_.name) + "\n0 0 0 " + std::to_string(90 * below(4)) + "\n" +
                       std::to_string(solid_.faces - 1) + " 0 0\n" + std::to_string(kFaceSize) + "\n";
    for (int face = 0; face < solid_.faces; ++face) {
      text += "%\n";
      for (const WordedLine& line : linesOf(face)) {
        for (const int number : {line.x0, line.y0, line.x1, line.y1}) text += std::to_string(number) + " ";
        text += line.word + "\n";
      }
    }
    return text;
  }

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<std::uint64_t>(limit)); }
  int coordinate(int reach) { return below(2 * reach + 1) - reach; }

  std::string word() {
    switch (below(11)) {
      case 0:
        return "up " + std::to_string(below(solid_.edges));
      case 1:
        return "hazard";
      case 2:
        return "key " + std::to_string(below(2));
      case 3:
      case 4:
        return "door " + std::to_string(below(3));
      case 5:
        return "plate " + std::to_string(below(3));
      case 6:
      case 7:
      case 8:
        return "oneway";
      case 9:
        return "timed " + std::to_string(1 + below(40)) + " " + std::to_string(1 + below(40));
      default:
        return {};
    }
  }

  // A line through the inner circle of the face, which may leave the face.
  WordedLine line() {
    const int x = coordinate(inradius_ * 7 / 10);
    const int y = coordinate(inradius_ * 7 / 10);
    const int reach = 10 + below(inradius_);
    return {x, y, x + coordinate(reach), y + 1 + below(reach), word()};
  }

  std::vector<WordedLine> linesOf(int face) {
    std::vector<WordedLine> lines;
    const int x = coordinate(inradius_ / 3);
    const int y = coordinate(inradius_ / 3);
    lines.push_back({x - 10, y, x + 10, y, "checkpoint"});
    while (lines.size() < kLinesOfFace) {
      WordedLine line = this->line();
      const bool isInTheWay = line.distanceTo(x, y) < kFree || (face == 0 && line.distanceTo(0, 0) < kFree);
      if (line.canBlock() && isInTheWay) continue;
      lines.push_back(line);
      if (below(6) != 0) continue;
      line.word = word();
      if (!line.canBlock() || !isInTheWay) lines.push_back(line);
    }
    return lines;
  }

  const Solid& solid_;
  std::mt19937_64 random_;
  int inradius_;
};

}  // namespace

std::string elementLevel(int solid, std::uint64_t seed) {
  return Generator(kSolids[static_cast<std::size_t>(solid)], seed).text();
}

}  // namespace platon
