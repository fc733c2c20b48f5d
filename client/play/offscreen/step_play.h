#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "client/gl/window.h"
#include "client/play/client_options.h"
#include "client/play/game_desk.h"
#include "client/play/screen.h"
#include "client/time/clock.h"
#include "client/ui/key.h"
#include "client/ui/pointer_event.h"
#include "protocol/time.h"

namespace platon {

/// The key with this name: that of the settings file, or what the player reads on it, in any case. Nothing if there is
/// none.
std::optional<Key> keyOfName(std::string_view name);

/// The program without a window, played by commands: keys and the mouse go in, pictures come out. The screens, the
/// menus and the match are those of the window. Time passes only in the commands that take some, 60 frames a second,
/// for the client and for the server in this program.
///
/// | command | what it does |
/// | --- | --- |
/// | `press KEY`, `release KEY` | holds a key down, lets it go |
/// | `tap KEY [SECONDS]` | holds a key down for this time, without one for a tenth of a second |
/// | `type TEXT` | types a text |
/// | `move X Y`, `click X Y` | moves the mouse to a pixel of the picture, and presses its left button there |
/// | `scroll NOTCHES` | turns the wheel of the mouse; away from the user is positive |
/// | `wait SECONDS` | lets time pass |
/// | `shot FILE` | writes what is to be seen to this PNG file |
/// | `quit` | closes the window |
class StepPlay {
 public:
  /// Shows the title, or plays options.level. Throws as OffscreenWindow and GameDesk do.
  explicit StepPlay(const ClientOptions& options);
  ~StepPlay();
  StepPlay(const StepPlay&) = delete;
  StepPlay& operator=(const StepPlay&) = delete;

  /// Carries out a command. Returns one line: `ok` and the seconds that have passed since the start, or `error:` and a
  /// sentence that says what is right; then nothing has happened. Throws ProgramError if a screen quits with an error.
  std::string obey(const std::string& command);
  /// False after `quit`, or when the player has quit in the menu: then no command does anything any more.
  bool isOpen() const { return screens_.isOpen(); }

  static constexpr double kTapSeconds = 0.1;
  static constexpr double kMaxSeconds = 600;  ///< of one command

 private:
  class Words;

  void perform(const std::string& command);
  void press(Words& words);
  void release(Words& words);
  void tap(Words& words);
  void type(Words& words);
  void move(Words& words);
  void click(Words& words);
  void scroll(Words& words);
  void wait(Words& words);
  void shoot(Words& words);
  void quit(Words& words);

  void pass(double seconds);
  void frame();
  void hold(Key key);
  void letGo(Key key);
  bool holds(Key key) const;
  void send(Key key, KeyEvent::Kind kind);
  void sendKey(Key key, KeyEvent::Kind kind);
  void sendCharacter(char32_t character);
  void send(PointerEvent::Kind kind);

  Time now_;
  std::uint64_t frames_ = 0;
  Clock clock_;
  OffscreenWindow window_;
  GameDesk desk_;
  ScreenStack screens_;
  std::vector<Key> held_;          // in the order in which they were pressed
  std::uint64_t repeatFrame_ = 0;  // in which the last one of them repeats; 0: none does
  PointerEvent pointer_;           // the last one
};

}  // namespace platon
