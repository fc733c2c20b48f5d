#include "client/editor/new_level.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>

#include "levels/drawing/level_marks.h"
#include "levels/drawing/solid_frame.h"

namespace platon {
namespace {

constexpr std::array<int, kSolidKinds> kFaceSizes{640, 480, 560, 320, 480};  // by SolidKind
constexpr int kGrid = 10;

int onGrid(double value) { return static_cast<int>(std::floor(value / kGrid)) * kGrid; }

}  // namespace

std::string newLevelText(SolidKind solid, const std::string& title) {
  const int size = kFaceSizes[static_cast<std::size_t>(solid)];
  const SolidFrame frame(solid, size);
  const int floor = -onGrid(frame.apothem() * 0.75);
  const int half = onGrid(frame.apothem() * 0.75);
  const int ball = static_cast<int>(LevelMarks::kBallRadius);
  const std::string segment = std::to_string(-half) + " " + std::to_string(floor) + " " + std::to_string(half) + " " +
                              std::to_string(floor) + "\n";
  std::string text = "# title: " + title + "\n" + std::string(nameOf(solid)) + "\n";
  text += "0 " + std::to_string(-half / 2) + " " + std::to_string(floor + ball) + " 0\n";
  text += "0 " + std::to_string(half / 2) + " " + std::to_string(floor + 2 * kGrid) + "\n";
  text += std::to_string(size) + "\n";
  for (int face = 0; face < frame.faces(); ++face) {
    text += "%  # face " + std::to_string(face) + "\n" + (face == 0 ? segment : "");
  }
  return text;
}

std::string titleOf(const std::string& fileName) {
  std::string title = fileName.substr(0, fileName.rfind(".level"));
  title.erase(0, std::min(title.find_first_not_of("0123456789_- "), title.size()));
  std::replace(title.begin(), title.end(), '_', ' ');
  std::erase_if(title, [](char letter) { return letter < ' ' || letter > '~'; });
  if (title.empty()) return "New level";
  title[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(title[0])));
  return title.substr(0, 100);
}

}  // namespace platon
