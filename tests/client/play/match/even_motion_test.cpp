#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "client/play/match/session_feeds.h"
#include "tests/net/support/session_network.h"
#include "tests/support/test_levels.h"

namespace platon::even_motion_test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Time kFrame = milliseconds(16);
constexpr int kFrames = 625;  // 10 s

const Controls kRight = [](const Game&, std::uint32_t) { return Input{Input::kRight}; };
const Controls kNoButtons = [](const Game&, std::uint32_t) { return Input{}; };

// Measures how far a player that runs right has moved around the solid, from its drawn pose.
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

struct Conditions {
  std::string name;
  LinkQuality quality;
  int idle = 0;  // idle players; with five players the server sends only every second tick
};

// One player runs around the solid, and another one watches it under simulated network conditions.
class Viewer {
 public:
  Viewer(const Conditions& conditions, std::uint64_t seed) : match_({endlessLevel()}, seed) {
    match_.join(LinkQuality(), kRight);
    match_.join(conditions.quality, kNoButtons);
    for (int i = 0; i < conditions.idle; ++i) match_.join(LinkQuality(), kNoButtons);
  }

  void pass(Time duration) { match_.run(duration); }
  // Drawn movement since the last call, units.
  double movement() {
    const std::optional<Scene> scene = feed_.scene(match_.session(1), match_.now());
    const double now = odometer_.read(*scene, scene->players.front().pose);
    return now - std::exchange(last_, now);
  }
  const InterpolationBuffer* buffer() const {
    const Round* const round = match_.session(1).round();
    return round == nullptr ? nullptr : &round->interpolationBuffer();
  }
  const Game& game() { return match_.match().game(); }

 private:
  SessionNetwork match_;
  SceneFeed feed_;
  Odometer odometer_;
  double last_ = 0;
};

LinkQuality qualityOf(double loss, double jitter, double delay) {
  LinkQuality quality;
  quality.lossPercent = loss;
  quality.jitterMs = jitter;
  quality.delayMs = delay;
  return quality;
}

class EvenMotionTest : public testing::TestWithParam<Conditions> {};

// The playback clock slews by at most 5 %, 1 % of the ticks may arrive too late for it, and the lattice rounds
// each movement by less than 0.1 %.
TEST_P(EvenMotionTest, OthersMoveAtTheirTrueSpeed) {
  constexpr int kSeeds = 10;
  constexpr double kSlew = InterpolationBuffer::kMaxSlew + 0.001;
  int uneven = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    Viewer viewer(GetParam(), seed);
    viewer.pass(seconds(5));
    viewer.movement();
    const double speed = double{1} * viewer.game().player(0).velocity.x / kSubunitsPerUnit;
    const double truth = speed * kTicksPerSecond * toSeconds(kFrame);
    ASSERT_GT(truth, 3);
    for (int frame = 0; frame < kFrames; ++frame) {
      viewer.pass(kFrame);
      uneven += std::abs(viewer.movement() / truth - 1) > kSlew ? 1 : 0;
    }
  }
  EXPECT_LE(uneven, kSeeds * kFrames / 100) << "of seeds 1 to " << kSeeds;
}

// Measures when ticks arrive, independently of the interpolation buffer.
class Arrivals {
 public:
  // `time` in ticks.
  void observe(double time, std::uint32_t newest) {
    for (; seen_ < newest; ++seen_) lateness_.push_back(time - (seen_ + 1));
  }
  // Quantile of the lateness of the last 512 ticks, relative to its minimum.
  double lateness(double share) const {
    std::vector<double> last(lateness_.end() - 512, lateness_.end());
    std::sort(last.begin(), last.end());
    return last[static_cast<std::size_t>(std::ceil(share * 512)) - 1] - last.front();
  }

 private:
  std::uint32_t seen_ = 0;
  std::vector<double> lateness_;
};

TEST_P(EvenMotionTest, TheInterpolationDelayMatchesTheMeasuredLateness) {
  constexpr Time kStep = std::chrono::microseconds(500);  // time step of the match
  constexpr double kResolution = 0.05;                    // ticks: one time step
  constexpr double kClientFrame = 0.24;                   // ticks: the last update was up to 4 ms ago
  Viewer viewer(GetParam(), 7);
  Arrivals arrivals;
  for (Time passed{}; passed < seconds(20); passed += kStep) {
    viewer.pass(kStep);
    const InterpolationBuffer* const buffer = viewer.buffer();
    if (buffer == nullptr) continue;
    arrivals.observe(toSeconds(passed) * kTicksPerSecond, buffer->newest());
    if (passed < seconds(15) || passed % kFrame != Time::zero()) continue;
    const double delay = arrivals.lateness(0.99) + 1 + InterpolationBuffer::kSpareTicks;
    ASSERT_NEAR(buffer->targetDelay(), delay, kResolution);
    const double behind = buffer->newest() - buffer->tick() - kClientFrame - kResolution;
    ASSERT_LE(behind, delay - std::min(buffer->error(), 0.0));
    ASSERT_LE(behind, arrivals.lateness(1) + 1 + InterpolationBuffer::kSpareTicks);
  }
  EXPECT_EQ(viewer.buffer()->jumps(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Conditions, EvenMotionTest,
                         testing::Values(Conditions{"Perfect", qualityOf(0, 0, 0)},
                                         Conditions{"Jitter", qualityOf(0, 100, 0)},
                                         Conditions{"LossAndJitter", qualityOf(10, 100, 0)},
                                         Conditions{"Delay", qualityOf(0, 0, 200)},
                                         Conditions{"EverySecondTickWithLossAndJitter", qualityOf(10, 100, 0), 3}),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace platon::even_motion_test
