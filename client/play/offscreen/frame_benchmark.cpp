#include "client/play/offscreen/frame_benchmark.h"

#include <cstddef>
#include <string>
#include <utility>

#include "client/gl/gl_context.h"
#include "client/gl/gl_objects.h"

namespace platon {
namespace {

std::vector<std::string> namesInBenchmark() {
  std::vector<std::string> names;
  for (std::uint32_t slot = 0; slot < BenchmarkGame::kPlayers; ++slot)
    names.push_back("Player " + std::to_string(slot + 1));
  return names;
}

constexpr double kFrameSeconds = double{1} / 60;

double toMilliseconds(Time moment) { return 1000 * toSeconds(moment); }

void drawOn(GameView& view, const Scene& scene) {
  view.draw(&scene, HudStatus(), Settings(), Overlay(), kFrameSeconds);
}

}  // namespace

BenchmarkGame::BenchmarkGame(std::shared_ptr<const Level> level) : game_(std::move(level), namesInBenchmark()) {
  begin();
}

void BenchmarkGame::begin() {
  game_.begin();
  inputs_.clear();
  prediction_.emplace(game_.game(), SlotsByLocal{0});
}

void BenchmarkGame::advance(std::uint32_t ticks) {
  for (std::uint32_t tick = 0; tick < ticks; ++tick) advance();
}

void BenchmarkGame::advance() {
  if (game_.game().tick() > 0 && game_.game().over()) begin();
  std::vector<Input> inputs(kPlayers);
  inputs[0] = demo_.choose(game_.game(), 0);
  for (std::uint32_t slot = 1; slot < kPlayers; ++slot) {
    const std::size_t delay = std::size_t{slot} * kTicksBetween;
    if (delay <= inputs_.size()) inputs[slot] = inputs_[inputs_.size() - delay][0];
  }
  for (Input& input : inputs) input.buttons |= Input::kPresent;
  game_.advance(inputs);
  inputs_.push_back(std::move(inputs));
}

void BenchmarkGame::predict() {
  const std::uint32_t tick = prediction_->predictedTicks();
  if (tick >= inputs_.size()) return;
  if (tick >= kLead) {
    prediction_->confirm(inputs_[prediction_->confirmedTicks()]);
    prediction_->reconcile(Time());
  }
  prediction_->predict({inputs_[tick][0]});
}

FrameBenchmark::Course::Course(const NamedQuality& named) : level(named.level) {
  view.setQuality(named.quality);
  commands.setQuality(named.quality);
}

FrameBenchmark::FrameBenchmark(std::shared_ptr<const Level> level, Clocks clocks)
    : clocks_(std::move(clocks)), game_(std::move(level)) {
  for (const NamedQuality& named : kQualities) courses_.emplace_back(named);
  for (const Scene& scene : nextScenes()) {
    for (Course& course : courses_) {
      drawOn(course.view, scene);
      drawOn(course.commands, scene);
    }
  }
  sceneTimes_ = {};
  tickTimes_ = {};
}

void FrameBenchmark::measure() {
  const std::vector<Scene> scenes = nextScenes();
  for (Course& course : courses_) {
    for (const Scene& scene : scenes) draw(course, scene);
    for (const Scene& scene : scenes) drawWithheld(course, scene);
  }
  frames_ += kFramesInTurn;
}

BenchmarkReport FrameBenchmark::report() const {
  BenchmarkReport report;
  report.driver = driverName();
  report.frames = frames_;
  for (const Course& course : courses_) report.costs[static_cast<std::size_t>(course.level)] = costOf(course);
  return report;
}

std::vector<Scene> FrameBenchmark::nextScenes() {
  std::vector<Scene> scenes;
  for (std::uint32_t i = 0; i < kFramesInTurn; ++i) {
    game_.advance(kTicksBetween);
    for (std::uint32_t tick = 0; tick < kTicksBetween; ++tick) {
      const Time begin = clocks_.own();
      game_.predict();
      tickTimes_.add(toMilliseconds(clocks_.own() - begin));
    }
    const Time before = clocks_.own();
    scenes.push_back(game_.scene());
    sceneTimes_.add(toMilliseconds(clocks_.own() - before));
  }
  return scenes;
}

void FrameBenchmark::draw(Course& course, const Scene& scene) const {
  const std::uint64_t calls = DrawCalls::count();
  const Time allBefore = clocks_.all();
  const Time before = clocks_.wall();
  drawOn(course.view, scene);
  finishDrawing();
  course.times.add(toMilliseconds(clocks_.wall() - before));
  course.allTimes.add(toMilliseconds(clocks_.all() - allBefore));
  course.drawCalls.add(static_cast<double>(DrawCalls::count() - calls));
}

void FrameBenchmark::drawWithheld(Course& course, const Scene& scene) const {
  DrawCalls::withhold(true);
  const Time before = clocks_.own();
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
