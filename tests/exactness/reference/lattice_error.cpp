#include "tests/exactness/reference/lattice_error.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "tests/exactness/reference/ideal_path.h"
#include "tests/exactness/reference/simulated_body.h"
#include "tests/support/files.h"

namespace platon::reference {
namespace {

/// The simulated body at one resolution, and its distance from the ideal one.
class LatticeBody {
 public:
  LatticeBody(const ExactScene& scene, std::int64_t resolution)
      : body_(scaled(scene, resolution / kSceneSubunits)), resolution_(resolution) {}

  void tick(const RationalVec& ideal) {
    body_.tick();
    const std::int64_t factor = resolution_ / kSceneSubunits;
    distance_ = distance(body_.position(), {ideal.x * factor, ideal.y * factor});
    max_ = std::max(max_, distance_);
  }

  LatticeError report(const std::string& scene, std::int64_t ticks) const {
    return {scene, resolution_, ticks, body_.legs(), distance_, max_};
  }

 private:
  SimulatedBody body_;
  std::int64_t resolution_;
  double distance_ = 0;
  double max_ = 0;
};

}  // namespace

std::vector<LatticeError> latticeErrors(const std::string& name, const ExactScene& scene,
                                        std::span<const std::int64_t> resolutions,
                                        std::span<const std::int64_t> ticks) {
  const IdealPath ideal(scene, ticks.back());
  std::vector<LatticeBody> bodies;
  for (const std::int64_t resolution : resolutions) bodies.emplace_back(scene, resolution);
  std::vector<LatticeError> errors;
  for (std::int64_t tick = 1; tick <= ticks.back(); ++tick) {
    for (LatticeBody& body : bodies) body.tick(ideal.positionAt(tick));
    if (!std::binary_search(ticks.begin(), ticks.end(), tick)) continue;
    for (const LatticeBody& body : bodies) errors.push_back(body.report(name, tick));
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

}  // namespace platon::reference
