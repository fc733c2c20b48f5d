#include "client/play/offscreen/offscreen_play.h"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "client/gl/image.h"

namespace platon {

namespace {

constexpr Time kToldInterval = std::chrono::seconds(2);

MatchChoice choiceOffscreen(const ClientOptions& options) {
  MatchChoice choice{options.server, options.knowledge.password};
  if (!options.level.empty()) choice.own.levels = {options.level};
  return choice;
}

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

OffscreenPlay::OffscreenPlay(const ClientOptions& options, const Clock& clock)
    : options_(options), match_(options, choiceOffscreen(options), clock) {}

void OffscreenPlay::update() {
  match_.update(false, [this](const Game& game, std::uint32_t slot) { return choose(game, slot); });
  if (match_.client().ending()) throw ProgramError(ProgramError::kFailed, *match_.client().ending());
}

Input OffscreenPlay::choose(const Game& game, std::uint32_t slot) {
  return options_.demo ? demo_.choose(game, slot) : Input{};
}

void OffscreenPlay::finish() {
  if (!options_.screenshot.empty()) {
    GameView view(kPictureWidth, kPictureHeight);
    const std::optional<Scene> scene = match_.scene();
    view.setQuality(kBestQuality);
    view.draw(scene ? &*scene : nullptr, match_.hudStatus(), Settings(), Overlay(), 0);
    writeScreenshot(view.read(), options_.screenshot);
  }
  const std::string unfinished = match_.message();
  match_.leave();
  if (!unfinished.empty()) throw ProgramError(ProgramError::kFailed, "time limit reached: " + unfinished);
}

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

void FramePlay::advance() {
  play();
  if (tick_ >= firstTick_ && (tick_ - firstTick_) % ticksPerFrame_ == 0)
    writeFrame((tick_ - firstTick_) / ticksPerFrame_);
  ++tick_;
}

void FramePlay::play() {
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

OffscreenReplay::OffscreenReplay(const ClientOptions& options, const Settings& settings, Time now)
    : options_(options), settings_(settings), replay_(options.replay), toldAt_(now) {}

bool OffscreenReplay::read(Time now) {
  replay_.advance(0);
  if (!replay_.fault().empty()) throw ProgramError(ProgramError::kInvalid, replay_.fault());
  if (replay_.viewer() != nullptr) return true;
  if (now - toldAt_ < kToldInterval) return false;
  toldAt_ = now;
  std::fprintf(stderr, "platon-client: %s\n", replay_.readingText().c_str());
  return false;
}

ProgramError OffscreenReplay::stopped() const {
  return {ProgramError::kFailed, options_.replay + ": " + Replay::kStopped};
}

void OffscreenReplay::draw() {
  const Offscreen offscreen;
  GameView view(kPictureWidth, kPictureHeight);
  replay_.skipTo(options_.seconds.value_or(viewer().player().replay().ticks()));
  drawReplay(viewer(), view, settings_, 0);
  if (!options_.screenshot.empty()) writeScreenshot(view.read(), options_.screenshot);
}

}  // namespace platon
