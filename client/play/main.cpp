#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/lobby/listed_servers.h"
#include "client/lobby/near_servers.h"
#include "client/lobby/shipped_levels.h"
#include "client/play/client_options.h"
#include "client/play/editor_screen.h"
#include "client/play/game_desk.h"
#include "client/play/offscreen/frame_benchmark.h"
#include "client/play/offscreen/offscreen_play.h"
#include "client/play/offscreen/step_play.h"
#include "client/play/screen.h"
#include "client/play/title_screen.h"
#include "client/time/steady_now.h"
#include "protocol/program_error.h"
#include "server/app/level_files.h"

namespace platon {
namespace {

constexpr Time kUpdateInterval = std::chrono::milliseconds(4);
constexpr Time kAnalysisInterval = std::chrono::milliseconds(10);
constexpr double kEditSeconds = 10;  // for the analysis, off-screen

// Set by a signal, which may arrive in any thread.
std::atomic<bool> stopSignal = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

// Shows screens until the player leaves, the program is stopped, or its time is up.
void show(ScreenStack& screens, Window& window, const Clock& clock, std::optional<double> seconds) {
  const Time start = clock.now();
  Time before = start;
  for (Time now = start; screens.isOpen() && !stopSignal; now = clock.now()) {
    if (seconds && toSeconds(now - start) >= *seconds) break;
    const Frame frame{now, toSeconds(now - std::exchange(before, now))};
    window.poll();
    for (const WindowEvent& event : window.takeEvents()) screens.handle(event);
    screens.update(frame);
    if (!window.minimised()) {
      screens.draw(frame);
      window.show();
    }
    clock.sleepUntil(now + screens.frameTime());
  }
  screens.close();
}

void playInWindow(const ClientOptions& options, const Clock& clock) {
  DesktopWindow window = openWindow("to play without one, use --offscreen");
  GameDesk desk(options, clock, window);
  ScreenStack screens(std::make_unique<TitleScreen>(desk));
  show(screens, window, clock, options.seconds);
  if (desk.named.failure) throw ProgramError(*desk.named.failure);
}

void playOffscreen(const ClientOptions& options, const Clock& clock) {
  OffscreenPlay play(options, clock);
  const Time start = clock.now();
  const double seconds = options.seconds.value_or(OffscreenPlay::kSeconds);
  for (Time now = start; toSeconds(now - start) < seconds && !stopSignal; now = clock.now()) {
    play.update();
    clock.sleepUntil(now + kUpdateInterval);
  }
  play.finish();
}

// Ends at the end of the input, or by a signal, which ends the program at once.
void playInSteps(const ClientOptions& options) {
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
  StepPlay play(options);
  std::puts("ready");
  std::fflush(stdout);
  for (std::string command; play.isOpen() && std::getline(std::cin, command);) {
    std::puts(play.obey(command).c_str());
    std::fflush(stdout);
  }
}

void edit(const ClientOptions& options, const Clock& clock) {
  EditSession session(options.edit, options.solid);
  if (!options.offscreen) {
    DesktopWindow window = openWindow("to draw the editor without one, use --offscreen --screenshot");
    const Settings settings = SettingsFile(configFolder()).load();
    ScreenStack screens(std::make_unique<EditorScreen>(session, window, settings, options.screenshot));
    return show(screens, window, clock, options.seconds);
  }
  const Offscreen offscreen;
  EditorPicture picture{Settings()};
  const Time start = clock.now();
  const double seconds = options.seconds.value_or(kEditSeconds);
  for (Time now = start; toSeconds(now - start) < seconds && !stopSignal && !session.analyse(); now = clock.now())
    clock.sleepUntil(now + kAnalysisInterval);
  picture.draw(session.editor());
  writeScreenshot(picture.read(), options.screenshot);
}

void drawRecording(const ClientOptions& options, const Clock& clock) {
  OffscreenReplay replay(options, SettingsFile(configFolder()).load(), clock.now());
  for (Time now = clock.now(); !replay.read(now); now = clock.now()) {
    if (stopSignal) throw replay.stopped();
    clock.sleepUntil(now + kUpdateInterval);
  }
  replay.draw();
}

void writeFrames(const ClientOptions& options) {
  FramePlay play(options, loadLevelFiles({options.level}).levels.front());
  while (!play.done() && !stopSignal) play.advance();
}

void benchmark(const ClientOptions& options) {
  const std::vector<std::string> files =
      options.level.empty() ? gameLevelFiles() : std::vector<std::string>{options.level};
  FrameBenchmark benchmark(loadLevelFiles({files.front()}).levels.front(),
                           {steadyClock().now, programTime, threadTime});
  do {
    benchmark.measure();
  } while (!benchmark.done() && !stopSignal);
  const BenchmarkReport report = benchmark.report();
  std::fputs((options.json ? toJson(report) : toText(report)).c_str(), stdout);
}

// One search; a server in the same network answers within milliseconds.
void listNearServers(const Clock& clock) {
  NearServers servers = searchNearby();
  for (const Time end = clock.now() + std::chrono::seconds(1); clock.now() < end && !stopSignal;) {
    servers.update(clock.now());
    servers.socket().wait(std::chrono::milliseconds(20));
  }
  servers.update(clock.now());
  if (servers.list().empty())
    std::fputs("platon-client: no server nearby answers; ask the owner of a server for its address\n", stderr);
  std::fputs(textOf(servers.list()).c_str(), stdout);
}

// Returns the exit code: 1 if the list could not be read as a whole.
int printListedServers(const std::string& url, const Clock& clock) {
  ListedServers servers(url);
  for (Time end = clock.now() + std::chrono::seconds(1); clock.now() < end && !stopSignal;) {
    servers.update(clock.now());
    if (servers.reading()) end = clock.now() + std::chrono::seconds(1);
    servers.wait(std::chrono::milliseconds(20));
  }
  servers.update(clock.now());
  for (const std::string& fault : servers.faults()) std::fprintf(stderr, "platon-client: %s\n", fault.c_str());
  if (servers.list().empty() && servers.faults().empty())
    std::fputs("platon-client: no server in the list answers\n", stderr);
  std::fputs(textOf(servers.list()).c_str(), stdout);
  return servers.faults().empty() ? 0 : 1;
}

int listServers(const ClientOptions& options, const Clock& clock) {
  if (!options.listUrl.empty()) return printListedServers(options.listUrl, clock);
  listNearServers(clock);
  return 0;
}

int play(int argc, char** argv) {
  const std::optional<ClientOptions> options = readClientOptions(argc, argv);
  if (!options) return 0;
  std::signal(SIGTERM, [](int) { stopSignal = true; });
  std::signal(SIGINT, [](int) { stopSignal = true; });
  const Clock clock = steadyClock();
  if (!options->frames.folder.empty()) {
    writeFrames(*options);
  } else if (options->list) {
    return listServers(*options, clock);
  } else if (options->benchmark) {
    benchmark(*options);
  } else if (options->step) {
    playInSteps(*options);
  } else if (!options->edit.empty()) {
    edit(*options, clock);
  } else if (!options->offscreen) {
    playInWindow(*options, clock);
  } else if (!options->replay.empty()) {
    drawRecording(*options, clock);
  } else {
    playOffscreen(*options, clock);
  }
  return 0;
}

int fail(int exitCode, const char* prefix, const char* what) {
  std::fprintf(stderr, "%s%s\n", prefix, what);
  return exitCode;
}

}  // namespace
}  // namespace platon

int main(int argc, char** argv) {
  using platon::ProgramError;
  try {
    return platon::play(argc, argv);
  } catch (const ProgramError& error) {
    const bool level = error.exitCode() == ProgramError::kInvalid;
    return platon::fail(error.exitCode(), level ? "" : "platon-client: ", error.what());
  } catch (const std::exception& error) {
    return platon::fail(ProgramError::kFailed, "platon-client: ", error.what());
  }
}
