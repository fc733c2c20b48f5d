#include "client/play/offscreen/frame_play.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "client/gl/image.h"
#include "client/lobby/shipped_levels.h"

namespace platon {

namespace {

constexpr std::array<const char*, 4> kNames{"Ada", "Grace", "Emmy", "Sofia"};

std::uint32_t toTicks(double seconds) { return static_cast<std::uint32_t>(std::lround(seconds * kTicksPerSecond)); }

std::vector<std::string> namesOfPlayers(std::uint32_t players) {
  std::vector<std::string> names;
  for (std::uint32_t slot = 0; slot < players; ++slot) names.emplace_back(kNames[slot % kNames.size()]);
  return names;
}

std::string frameFile(const std::string& folder, std::uint32_t frame) {
  std::array<char, 16> name{};
  std::snprintf(name.data(), name.size(), "/%04u.png", frame);
  return folder + name.data();
}

}  // namespace

FramePlay::FramePlay(const ClientOptions& options, std::shared_ptr<const Level> level)
    : options_(options.frames),
      ticksPerFrame_(static_cast<std::uint32_t>(kTicksPerSecond / options_.perSecond)),
      firstTick_(toTicks(options_.from)),
      endTick_(firstTick_ + toTicks(options.seconds.value_or(kSeconds))),
      view_(options_.width, options_.width * 9 / 16),
      game_(std::move(level), namesOfPlayers(options_.players)),
      demos_(options_.players, Demo(shippedWay)) {
  view_.setQuality(kBestQuality);
}

void FramePlay::run(const std::function<bool()>& stopRequested) {
  for (std::uint32_t tick = 0; tick < endTick_ && !stopRequested(); ++tick) {
    advance();
    if (tick >= firstTick_ && (tick - firstTick_) % ticksPerFrame_ == 0) {
      writeFrame((tick - firstTick_) / ticksPerFrame_);
    }
  }
}

void FramePlay::advance() {
  std::vector<Input> inputs(options_.players);
  for (std::uint32_t slot = 0; slot < options_.players; ++slot) {
    if (game_.game().tick() < slot * kTicksBetweenStarts) continue;
    inputs[slot] = demos_[slot].choose(game_.game(), slot);
    inputs[slot].buttons |= Input::kPresent;
  }
  game_.advance(inputs);
}

void FramePlay::writeFrame(std::uint32_t frame) {
  const Scene scene = game_.scene();
  Settings settings;
  settings.zoom = options_.zoom;
  view_.draw(&scene, HudStatus(), settings, Overlay(), double{1} / options_.perSecond);
  writePng(view_.read(), frameFile(options_.folder, frame));
}

}  // namespace platon
