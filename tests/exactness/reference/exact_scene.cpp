#include "tests/exactness/reference/exact_scene.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace platon::reference {
namespace {

using oracle::Vec;

std::vector<Vec> vectorsOf(std::istringstream& words) {
  std::vector<std::int64_t> numbers;
  for (std::int64_t number = 0; words >> number;) {
    if (std::abs(number) >= kSceneLimit) throw std::runtime_error("numbers must be below 2^20");
    numbers.push_back(number);
  }
  if (!words.eof()) throw std::runtime_error("not a whole number");
  if (numbers.size() % 2 != 0) throw std::runtime_error("odd number of coordinates");
  std::vector<Vec> vectors;
  for (std::size_t i = 0; i < numbers.size(); i += 2) vectors.push_back({numbers[i], numbers[i + 1]});
  return vectors;
}

void take(ExactScene& scene, const std::string& line) {
  std::istringstream words(line);
  std::string name;
  if (!(words >> name) || name.front() == '#') return;
  const std::vector<Vec> vectors = vectorsOf(words);
  if (name == "shape" && oracle::isStrictlyConvex(vectors)) {
    scene.shape = vectors;
  } else if (name == "line" && vectors.size() == 2) {
    scene.lines.push_back({vectors[0], vectors[1]});
  } else if (name == "entity" && vectors.size() == 1) {
    scene.start = vectors[0];
  } else if (name == "velocity" && vectors.size() == 1) {
    scene.velocity = vectors[0];
  } else {
    throw std::runtime_error("not a line of a scene: " + line);
  }
}

}  // namespace

ExactScene readScene(std::string_view text) {
  ExactScene scene;
  std::istringstream stream{std::string(text)};
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    try {
      take(scene, line);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error("line " + std::to_string(number) + ": " + error.what());
    }
  }
  if (scene.shape.empty()) throw std::runtime_error("the scene has no shape");
  return scene;
}

ExactScene scaled(const ExactScene& scene, std::int64_t factor) {
  ExactScene fine = scene;
  for (Vec& vertex : fine.shape) vertex = factor * vertex;
  for (oracle::Segment& line : fine.lines) line = {factor * line.a, factor * line.b};
  fine.start = factor * scene.start;
  fine.velocity = factor * scene.velocity;
  return fine;
}

}  // namespace platon::reference
