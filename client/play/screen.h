#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "client/gl/image.h"
#include "client/gl/window.h"
#include "client/play/match/live_match.h"
#include "protocol/program_error.h"
#include "protocol/time.h"
#include "protocol/transport/server_address.h"

namespace platon {

/// One turn of the loop of the client.
struct Frame {
  Time now{};
  double seconds = 0;  ///< since the last one
};

/// A match has ended before the server has let the player in.
struct MatchRefused {
  ProgramError error;
  bool asksPassword = false;            ///< the server asks for a password, or for another one
  std::optional<ServerAddress> next{};  ///< where it has told to go on
};

/// A recording is no longer watched.
struct ReplayEnd {
  std::filesystem::path file;
  std::string fault{};  ///< why it cannot be played, a sentence; empty: it can
};

/// What a screen leaves to the one behind it: nothing, the match to play now, or how it has ended.
using Ending = std::variant<std::monostate, MatchChoice, MatchRefused, ReplayEnd>;

class Screen;

// What a screen wants next.
struct Stay {};
struct Push {
  std::unique_ptr<Screen> screen;  ///< comes in front of it
};
struct Replace {
  std::unique_ptr<Screen> screen;  ///< takes its place
};
struct Close {
  Ending ending{};
};
struct Quit {
  std::optional<ProgramError> error{};  ///< with which the program ends at once
};
using Next = std::variant<Stay, Push, Replace, Close, Quit>;

/// What a window shows at a time.
class Screen {
 public:
  virtual ~Screen() = default;

  virtual Next handle(const WindowEvent& event) = 0;
  virtual Next update(const Frame& frame) = 0;
  virtual void draw(const Frame& frame) = 0;
  /// Least time from one frame to the next.
  virtual Time frameTime() const = 0;
  /// What it has drawn last.
  virtual Image read() const = 0;

  /// Takes the place of `update` while other screens are in front of it. Returns whether it has to come to the front.
  virtual bool updateBehind(const Frame& /*frame*/) { return false; }
  /// It comes to the front, because the screen that was there has ended like this.
  virtual Next reveal(const Ending& /*ending*/) { return Stay{}; }
  /// Is called before it closes.
  virtual void leave() {}
};

/// The screens of a window, the last one in front. Events and frames go to that one, and what it wants is done at once.
class ScreenStack {
 public:
  explicit ScreenStack(std::unique_ptr<Screen> first);

  /// Whether there is something to show: a screen, and none has quit. The other functions have no effect otherwise.
  bool isOpen() const { return !screens_.empty() && !quit_; }
  /// These two throw ProgramError if a screen quits with an error.
  void handle(const WindowEvent& event);
  void update(const Frame& frame);
  void draw(const Frame& frame);
  Time frameTime() const { return isOpen() ? screens_.back()->frameTime() : Time(); }
  /// Of the screen in front; empty if there is none.
  Image read() const { return isOpen() ? screens_.back()->read() : Image(); }
  /// Closes all screens, from the front to the back.
  void close();

  /// The screen of this kind that is farthest in front; null if there is none.
  template <class Kind>
  const Kind* find() const {
    for (auto screen = screens_.rbegin(); screen != screens_.rend(); ++screen) {
      if (const auto* const found = dynamic_cast<const Kind*>(screen->get())) return found;
    }
    return nullptr;
  }

 private:
  void perform(Next next);
  void pop();

  std::vector<std::unique_ptr<Screen>> screens_;
  bool quit_ = false;
};

/// Size of the program's pictures: off-screen in pixels, of a new window in screen coordinates.
inline constexpr std::uint32_t kPictureWidth = 1280;
inline constexpr std::uint32_t kPictureHeight = 720;

/// Shortest time of a picture, for drivers that do not wait for the vertical blank.
inline constexpr Time kMinFrameTime = std::chrono::milliseconds(2);

/// Least time from one picture to the next while the player does not look at a game that runs.
inline constexpr Time kCalmFrameTime = std::chrono::microseconds(33'333);

/// Least time from one picture to the next: kCalmFrameTime in a `calm` window, else that of `frameCap` pictures a
/// second (Settings::frameCap), but at least kMinFrameTime.
Time frameTimeOf(bool calm, double frameCap);

/// In the title bar, unless the screen shows a file.
inline constexpr const char* kWindowTitle = "Platon";

/// Opens the window of the program. Throws ProgramError if there is none. Without a display its text ends with
/// `otherwise`, which says what can be done without a window.
DesktopWindow openWindow(const std::string& otherwise);

/// Writes a picture for the option --screenshot, and says so.
void writeScreenshot(const Image& picture, const std::string& file);

}  // namespace platon
