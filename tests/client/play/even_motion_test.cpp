#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "client/play/scene_feed.h"
#include "tests/support/test_level.h"
#include "tests/support/virtual_match.h"

namespace platon {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Moment kFrame = milliseconds(16);
constexpr int kFrames = 625;  // 10 s

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };
const Controls kNothing = [](const Game&, std::uint32_t) { return Input{}; };

// How far a runner to the right has come round the solid, from its picture alone.
class Odometer {
 public:
  double read(const Scene& scene, const Pose& pose) {
    if (normal_ && *normal_ != pose.normal) faces_ += 1;
    normal_ = pose.normal;
    return faces_ * scene.stage->mesh.faceSize() + glm::dot(pose.position, glm::cross(pose.up, pose.normal));
  }

 private:
  std::optional<glm::dvec3> normal_;
  double faces_ = 0;
};

struct Line {
  std::string name;
  LinkQuality quality;
  int idle = 0;  // players who do nothing; of five players each is told every second tick only
};

// Somebody runs round the solid on a good line, seen by somebody who stands at the end of `line`.
class Watching {
 public:
  Watching(const Line& line, std::uint64_t seed) : match_({endlessLevel()}, seed) {
    match_.join(LinkQuality(), kRight);
    match_.join(line.quality, kNothing);
    for (int i = 0; i < line.idle; ++i) match_.join(LinkQuality(), kNothing);
  }

  void pass(Moment duration) { match_.run(duration); }
  // On the picture since the last call, units.
  double way() {
    const std::optional<Scene> scene = feed_.scene(match_.session(1), match_.now());
    const double now = odometer_.read(*scene, scene->players.front().pose);
    return now - std::exchange(last_, now);
  }
  const InterpolationBuffer* view() const {
    const Round* const round = match_.session(1).round();
    return round == nullptr ? nullptr : &round->interpolationBuffer();
  }
  const Game& game() { return match_.match().game(); }

 private:
  VirtualMatch match_;
  SceneFeed feed_;
  Odometer odometer_;
  double last_ = 0;
};

LinkQuality lineOf(double loss, double jitter, double delay) {
  LinkQuality line;
  line.lossPercent = loss;
  line.jitterMs = jitter;
  line.delayMs = delay;
  return line;
}

class EvenMotionTest : public testing::TestWithParam<Line> {};

// The view runs with real time within 5 %, and 1 % of the ticks may come too late for it; the lattice rounds each way
// by less than a thousandth.
TEST_P(EvenMotionTest, OthersMoveWithTheirOwnSpeed) {
  constexpr int kSeeds = 10;
  constexpr double kSlew = InterpolationBuffer::kMaxSlew + 0.001;
  int uneven = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Watching watching(GetParam(), seed);
    watching.pass(seconds(5));
    watching.way();
    const double speed = double{1} * watching.game().player(0).velocity.x / kSubunitsPerUnit;
    const double truth = speed * kTicksPerSecond * toSeconds(kFrame);
    ASSERT_GT(truth, 3);
    for (int frame = 0; frame < kFrames; ++frame) {
      watching.pass(kFrame);
      uneven += std::abs(watching.way() / truth - 1) > kSlew ? 1 : 0;
    }
  }
  EXPECT_LE(uneven, kSeeds * kFrames / 100) << "of seeds 1 to " << kSeeds;
}

// When the ticks came, measured from outside.
class Arrivals {
 public:
  // Time, ticks of it, and the newest tick then.
  void see(double time, std::uint32_t newest) {
    for (; seen_ < newest; ++seen_) lateness_.push_back(time - (seen_ + 1));
  }
  // Lateness of the last 512 ticks beyond the least of them, which `share` of them do not exceed.
  double lateness(double share) const {
    std::vector<double> last(lateness_.end() - 512, lateness_.end());
    std::sort(last.begin(), last.end());
    return last[static_cast<std::size_t>(std::ceil(share * 512)) - 1] - last.front();
  }

 private:
  std::uint32_t seen_ = 0;
  std::vector<double> lateness_;
};

TEST_P(EvenMotionTest, TheViewIsBehindByTheLatenessThereIs) {
  constexpr Moment kStep = std::chrono::microseconds(500);  // of the match
  constexpr double kResolution = 0.05;                      // ticks: that step
  constexpr double kClientFrame = 0.24;                     // ticks: the view was told the time 4 ms ago
  Watching watching(GetParam(), 7);
  Arrivals arrivals;
  for (Moment passed{}; passed < seconds(20); passed += kStep) {
    watching.pass(kStep);
    const InterpolationBuffer* const view = watching.view();
    if (view == nullptr) continue;
    arrivals.see(toSeconds(passed) * kTicksPerSecond, view->newest());
    if (passed < seconds(15) || passed % kFrame != Moment::zero()) continue;
    const double delay = arrivals.lateness(0.99) + 1 + InterpolationBuffer::kSpareTicks;
    ASSERT_NEAR(view->targetDelay(), delay, kResolution);
    const double behind = view->newest() - view->tick() - kClientFrame - kResolution;
    ASSERT_LE(behind, delay - std::min(view->error(), 0.0));
    ASSERT_LE(behind, arrivals.lateness(1) + 1 + InterpolationBuffer::kSpareTicks);
  }
  EXPECT_EQ(watching.view()->jumps(), 0u);
}

INSTANTIATE_TEST_SUITE_P(OnLines, EvenMotionTest,
                         testing::Values(Line{"Perfect", lineOf(0, 0, 0)}, Line{"Jitter", lineOf(0, 100, 0)},
                                         Line{"LossAndJitter", lineOf(10, 100, 0)}, Line{"Delay", lineOf(0, 0, 200)},
                                         Line{"EverySecondTickWithLossAndJitter", lineOf(10, 100, 0), 3}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace platon
