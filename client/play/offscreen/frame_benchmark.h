#pragma once

#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <vector>

#include "client/gl/game_view.h"
#include "client/gl/offscreen.h"
#include "client/play/offscreen/benchmark_game.h"
#include "client/quality/benchmark_report.h"
#include "client/time/quantile_window.h"
#include "protocol/moment.h"

namespace platon {

/// Measures what a frame costs in each quality: a match of 16 players with its head-up display, 1280 × 720 pixels,
/// without a window. The qualities take turns, so that all of them meet the same load of the machine.
class FrameBenchmark {
 public:
  static constexpr std::uint32_t kWidth = 1280;
  static constexpr std::uint32_t kHeight = 720;
  static constexpr std::size_t kFrames = 300;  ///< of each quality

  using Now = std::function<Moment()>;

  struct Clocks {
    Now wall;  ///< the time that passes
    Now all;   ///< for which processors have worked for the program
    Now own;   ///< for which a processor has worked for this thread
  };

  /// Throws std::runtime_error if there is no OpenGL.
  FrameBenchmark(std::shared_ptr<const Level> level, Clocks clocks);

  /// Draws the frames. If `stopRequested` returns true, it measures fewer of them.
  BenchmarkReport run(const std::function<bool()>& stopRequested);

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
};

}  // namespace platon
