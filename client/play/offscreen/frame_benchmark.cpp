#include "client/play/offscreen/frame_benchmark.h"

#include <cstddef>
#include <utility>

#include "client/gl/draw_calls.h"
#include "client/gl/gl_loader.h"

namespace platon {
namespace {

constexpr double kFrameSeconds = double{1} / 60;

double toMilliseconds(Moment moment) { return 1000 * toSeconds(moment); }

void drawOn(GameView& view, const Scene& scene) { view.draw(&scene, {}, Settings(), Overlay(), kFrameSeconds); }

}  // namespace

FrameBenchmark::Course::Course(const NamedQuality& named) : level(named.level) {
  view.setQuality(named.quality);
  commands.setQuality(named.quality);
}

FrameBenchmark::FrameBenchmark(std::shared_ptr<const Level> level, Clocks clocks)
    : clocks_(std::move(clocks)), game_(std::move(level)) {
  for (const NamedQuality& named : kQualities) courses_.emplace_back(named);
}

BenchmarkReport FrameBenchmark::run(const std::function<bool()>& stopRequested) {
  BenchmarkReport report;
  report.driver = driverName();
  // The first turn prepares the driver and loads the level.
  for (const Scene& scene : nextScenes()) {
    for (Course& course : courses_) {
      drawOn(course.view, scene);
      drawOn(course.commands, scene);
    }
  }
  sceneTimes_ = {};
  tickTimes_ = {};
  for (; report.frames < kFrames && !(report.frames > 0 && stopRequested()); report.frames += kFramesInTurn) {
    const std::vector<Scene> scenes = nextScenes();
    for (Course& course : courses_) {
      for (const Scene& scene : scenes) draw(course, scene);
      for (const Scene& scene : scenes) drawWithheld(course, scene);
    }
  }
  for (const Course& course : courses_) report.costs[static_cast<std::size_t>(course.level)] = costOf(course);
  return report;
}

std::vector<Scene> FrameBenchmark::nextScenes() {
  std::vector<Scene> scenes;
  for (std::uint32_t i = 0; i < kFramesInTurn; ++i) {
    game_.advance(kTicksBetween);
    for (std::uint32_t tick = 0; tick < kTicksBetween; ++tick) {
      const Moment begin = clocks_.own();
      game_.predict();
      tickTimes_.add(toMilliseconds(clocks_.own() - begin));
    }
    const Moment before = clocks_.own();
    scenes.push_back(game_.scene());
    sceneTimes_.add(toMilliseconds(clocks_.own() - before));
  }
  return scenes;
}

void FrameBenchmark::draw(Course& course, const Scene& scene) const {
  const std::uint64_t calls = DrawCalls::count();
  const Moment allBefore = clocks_.all();
  const Moment before = clocks_.wall();
  drawOn(course.view, scene);
  finishDrawing();
  course.times.add(toMilliseconds(clocks_.wall() - before));
  course.allTimes.add(toMilliseconds(clocks_.all() - allBefore));
  course.drawCalls.add(static_cast<double>(DrawCalls::count() - calls));
}

void FrameBenchmark::drawWithheld(Course& course, const Scene& scene) const {
  DrawCalls::withhold(true);
  const Moment before = clocks_.own();
  drawOn(course.commands, scene);
  course.ownTimes.add(toMilliseconds(clocks_.own() - before));
  DrawCalls::withhold(false);
}

FrameCost FrameBenchmark::costOf(const Course& course) const {
  return {course.level,
          course.times.quantile(0.5),
          course.times.quantile(0.99),
          course.allTimes.quantile(0.5),
          tickTimes_.quantile(0.5) + sceneTimes_.quantile(0.5) + course.ownTimes.quantile(0.5),
          static_cast<std::uint32_t>(course.drawCalls.quantile(0.5))};
}

}  // namespace platon
