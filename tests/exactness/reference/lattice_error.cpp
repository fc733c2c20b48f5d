#include "tests/exactness/reference/lattice_error.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/simulated_body.h"
#include "tests/support/files.h"

namespace platon::reference {
namespace {

/// The simulated and the ideal body at one resolution, and their distance.
class LatticeBody {
 public:
  LatticeBody(const ExactScene& scene, std::int64_t resolution, std::int64_t ticks)
      : body_(scaled(scene, resolution / kSceneSubunits)),
        ideal_(scaled(scene, resolution / kSceneSubunits), ticks),
        resolution_(resolution) {}

  void tick() {
    body_.tick();
    distance_ = distance(body_.position(), ideal_.positionAt(++ticks_));
    max_ = std::max(max_, distance_);
  }

  LatticeError report(const std::string& scene) const {
    return {scene, resolution_, ticks_, body_.legs(), distance_, max_};
  }

 private:
  SimulatedBody body_;
  IdealPath ideal_;
  std::int64_t resolution_;
  std::int64_t ticks_ = 0;
  double distance_ = 0;
  double max_ = 0;
};

}  // namespace

std::vector<LatticeError> latticeErrors(const std::string& name, const ExactScene& scene,
                                        std::span<const std::int64_t> resolutions,
                                        std::span<const std::int64_t> ticks) {
  std::vector<LatticeBody> bodies;
  for (const std::int64_t resolution : resolutions) bodies.emplace_back(scene, resolution, ticks.back());
  std::vector<LatticeError> errors;
  for (std::int64_t tick = 1; tick <= ticks.back(); ++tick) {
    for (LatticeBody& body : bodies) body.tick();
    if (!std::binary_search(ticks.begin(), ticks.end(), tick)) continue;
    for (const LatticeBody& body : bodies) errors.push_back(body.report(name));
  }
  return errors;
}

std::vector<std::pair<std::string, ExactScene>> allScenes() {
  std::vector<std::pair<std::string, ExactScene>> scenes;
  for (const std::string& file : filesIn("tests/exactness/reference/scenes", ".scene")) {
    try {
      scenes.emplace_back(std::filesystem::path(file).stem().string(), readScene(readText(file)));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(file + ": " + error.what());
    }
  }
  return scenes;
}

std::vector<std::pair<std::string, ExactScene>> allSlowScenes() {
  constexpr std::int64_t kSubunits = 1024;
  constexpr std::int64_t kSlowness = 10;
  auto scenes = allScenes();
  for (auto& [name, scene] : scenes) {
    scene = scaled(scene, kSubunits / kSceneSubunits);
    scene.velocity = {scene.velocity.x / kSlowness, scene.velocity.y / kSlowness};
  }
  return scenes;
}

}  // namespace platon::reference
