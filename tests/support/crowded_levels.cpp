#include "tests/support/crowded_levels.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <random>

namespace platon {
namespace {

struct Line {
  double x0, y0, x1, y1;
};

/// Writes a level in which every face has the same lines. Lines outside a face are left out by the caller.
class LevelWriter {
 public:
  LevelWriter(const std::string& solid, const std::string& start, int size)
      : text_(solid + "\n" + start + "\n1 0 0\n" + std::to_string(size) + "\n") {}

  void face(const std::vector<Line>& lines) {
    text_ += "%\n";
    char words[128];
    for (const Line& line : lines) {
      std::snprintf(words, sizeof(words), "%.4f %.4f %.4f %.4f\n", line.x0, line.y0, line.x1, line.y1);
      text_ += words;
    }
  }
  std::string text() const { return text_; }

 private:
  std::string text_;
};

// The lines on face 0 of a hexahedron with faces of 480 units.
std::string onOneFace(const std::string& start, const std::vector<Line>& lines) {
  LevelWriter writer("HEXAHEDRON", start, 480);
  writer.face(lines);
  for (int face = 1; face < 6; ++face) writer.face({});
  return writer.text();
}

// A floor from one end of the face to the other, made of what `piece` puts at x, 6.4 of them a unit.
std::string floorOf(double crowding, const std::function<Line(double x, double width)>& piece) {
  const double width = 80.0 / (508 * crowding);
  std::vector<Line> lines;
  for (double x = -235; x < 235; x += width) lines.push_back(piece(x, width));
  return onOneFace("0 0 0 0", lines);
}

// Vertical lines of equal height side by side.
std::string comb(double crowding) {
  return floorOf(crowding, [](double x, double) { return Line{x, -20, x, -13}; });
}

// Vertical lines, of which every other one protrudes by four subunits.
std::string bumps(double crowding) {
  return floorOf(crowding, [lower = false](double x, double) mutable {
    lower = !lower;
    return Line{x, -20, x, lower ? -13.004 : -13};
  });
}

// Points, not quite at the same height.
std::string needles(double crowding) {
  return floorOf(crowding, [random = std::mt19937(7)](double x, double) mutable {
    const double y = -13 - static_cast<double>(random() % 20) / 1000;
    return Line{x, y, x, y};
  });
}

// Short slopes up and down.
std::string rough(double crowding) {
  return floorOf(crowding, [random = std::mt19937(7), y = -13.0](double x, double width) mutable {
    const double before = y;
    y = -13 - static_cast<double>(random() % 1000) / 1000;
    return Line{x, before, x + width, y};
  });
}

// Lines that all meet in a point under the start.
std::string star(double crowding) {
  const int count = static_cast<int>(511 * crowding);
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / count;
    lines.push_back({0, -14, 200 * std::cos(angle), -14 - 27 * std::sin(angle)});
  }
  lines.push_back({-230, -20, 230, -20});
  return onOneFace("0 0 0 0", lines);
}

// Long floors on top of each other.
std::string stack(double crowding) {
  const int count = static_cast<int>(512 * crowding);
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) lines.push_back({-230, -13 - 28.0 * i / count, 230, -13 - 28.0 * i / count});
  return onOneFace("0 0 0 0", lines);
}

// A shaft, down which players fall at full speed, in thick walls of points.
std::string shaft(double crowding) {
  const double gap = 2.25 / std::sqrt(crowding);
  std::vector<Line> lines;
  for (double y = -230; y < 235; y += gap) {
    for (double x = 13; x < 28; x += gap) {
      lines.push_back({x, y, x, y});
      lines.push_back({-x, y, -x, y});
    }
  }
  return onOneFace("0 0 200 0", lines);
}

// Long slopes side by side, as long together as is allowed: a query of the grid finds many that are not near.
std::string bundle(double crowding) {
  constexpr int kCount = 9600;
  const double gap = 0.196 / crowding;
  constexpr double kLength = 7290;
  constexpr double kX = 0.957826;  // direction of the slopes
  constexpr double kY = -0.287348;
  LevelWriter writer("HEXAHEDRON", "0 -3430.19 1042.21 0", 8300);
  std::vector<Line> lines;
  for (int i = 0; i < kCount; ++i) {
    const double x = -kLength * kX / 2 + i * gap * kY;
    const double y = -kLength * kY / 2 - i * gap * kX;
    lines.push_back({x, y, x + kLength * kX, y + kLength * kY});
  }
  writer.face(lines);
  for (int face = 1; face < 6; ++face) writer.face({});
  return writer.text();
}

// A comb on every face, round the solid. `reach`: half the width of a face at its height.
std::string combRound(const std::string& solid, int faces, double reach, double width) {
  LevelWriter writer(solid, "0 0 -6 0", 240);
  std::vector<Line> lines;
  for (double x = -reach; x < reach; x += width) lines.push_back({x, -27, x, -20});
  for (int face = 0; face < faces; ++face) writer.face(lines);
  return writer.text();
}

std::string combRoundHexahedron(double crowding) { return combRound("HEXAHEDRON", 6, 119, 0.158 / crowding); }
std::string combRoundTetrahedron(double crowding) { return combRound("TETRAHEDRON", 4, 90, 0.236 / crowding); }
std::string combRoundDodecahedron(double crowding) { return combRound("DODECAHEDRON", 12, 164, 0.174 / crowding); }

}  // namespace

std::vector<CrowdedLevel> crowdedLevels() {
  return {{"Comb", comb},
          {"Bumps", bumps},
          {"Needles", needles},
          {"Rough", rough},
          {"Star", star},
          {"Stack", stack},
          {"Shaft", shaft},
          {"Bundle", bundle},
          {"CombRoundHexahedron", combRoundHexahedron},
          {"CombRoundTetrahedron", combRoundTetrahedron},
          {"CombRoundDodecahedron", combRoundDodecahedron}};
}

}  // namespace platon
