#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include "client/demo/demo.h"
#include "client/gl/game_view.h"
#include "client/gl/gl_context.h"
#include "client/lobby/shipped_levels.h"
#include "client/netcode/prediction.h"
#include "client/play/offscreen/local_game.h"
#include "client/quality/benchmark_report.h"
#include "client/scene/scene.h"
#include "client/time/quantile_window.h"
#include "platon/game/game.h"
#include "protocol/time.h"

namespace platon {

/// The game that a benchmark draws: players who follow each other on the way of the demonstration, without a server
/// and a clock. The camera follows the first. When all have reached the goal, they begin anew.
class BenchmarkGame {
 public:
  static constexpr std::uint32_t kPlayers = 16;

  static constexpr std::uint32_t kLead = 6;  ///< of the prediction: ticks, a round trip of 100 ms

  explicit BenchmarkGame(std::shared_ptr<const Level> level);

  /// Plays this number of ticks.
  void advance(std::uint32_t ticks);
  /// Does what a client does in the next tick that was played and not predicted yet: takes the inputs of all players of
  /// kLead ticks before, reconciles, and predicts the tick with the input of the first player. Nothing is left to do
  /// after as many calls as ticks.
  void predict();
  /// What `predict` has made of this round.
  const Prediction& prediction() const { return *prediction_; }
  /// The moment to draw.
  Scene scene() const { return game_.scene(); }

 private:
  static constexpr std::uint32_t kTicksBetween = 12;  // from one player to the next

  void begin();
  void advance();

  LocalGame game_;
  Demo demo_{shippedWay};                   // of the first player
  std::vector<std::vector<Input>> inputs_;  // of the round, by tick and slot
  std::optional<Prediction> prediction_;    // of the round; always set
};

/// Measures what a frame costs in each quality: a match of 16 players with its head-up display, 1280 × 720 pixels,
/// without a window. The qualities take turns, so that all of them meet the same load of the machine.
class FrameBenchmark {
 public:
  static constexpr std::uint32_t kWidth = 1280;
  static constexpr std::uint32_t kHeight = 720;
  static constexpr std::size_t kFrames = 300;  ///< of each quality

  using Now = std::function<Time()>;

  struct Clocks {
    Now wall;  ///< the time that passes
    Now all;   ///< for which processors have worked for the program
    Now own;   ///< for which a processor has worked for this thread
  };

  /// Prepares the driver and loads the level. Throws std::runtime_error if there is no OpenGL.
  FrameBenchmark(std::shared_ptr<const Level> level, Clocks clocks);

  /// Whether all frames have been measured.
  bool done() const { return frames_ >= kFrames; }
  /// Measures some frames of each quality.
  void measure();
  /// What the frames have cost that were measured so far. `measure` has been called.
  BenchmarkReport report() const;

 private:
  static constexpr std::size_t kFramesInTurn = 10;
  static constexpr std::uint32_t kTicksBetween = 2;

  // The views of one quality, and what their frames took, in milliseconds.
  struct Course {
    explicit Course(const NamedQuality& named);

    QualityLevel level;
    GameView view{kWidth, kHeight};
    GameView commands{kWidth, kHeight};  // whose draw calls are withheld
    QuantileWindow<kFrames> times;
    QuantileWindow<kFrames> allTimes;
    QuantileWindow<kFrames> ownTimes;
    QuantileWindow<kFrames> drawCalls;
  };

  std::vector<Scene> nextScenes();
  void draw(Course& course, const Scene& scene) const;
  void drawWithheld(Course& course, const Scene& scene) const;
  FrameCost costOf(const Course& course) const;

  Clocks clocks_;
  Offscreen offscreen_;
  BenchmarkGame game_;
  QuantileWindow<kFrames> sceneTimes_;  // of the processor
  QuantileWindow<kFrames> tickTimes_;   // of the processor: a tick of the prediction
  std::list<Course> courses_;           // in the order of kQualities
  std::uint32_t frames_ = 0;            // that were measured of each
};

}  // namespace platon
