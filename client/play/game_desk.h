#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/gl/game_view.h"
#include "client/gl/screenshot_writer.h"
#include "client/gl/window.h"
#include "client/lobby/remembered.h"
#include "client/menu/menu.h"
#include "client/play/client_options.h"
#include "client/play/match/session_feeds.h"
#include "client/play/screen.h"
#include "client/play/settings_preview.h"
#include "client/quality/quality_meter.h"
#include "client/time/clock.h"
#include "client/ui/controls/gamepad_keys.h"
#include "client/ui/hints/new_player_hints.h"
#include "client/ui/medal.h"
#include "client/ui/user_interface.h"
#include "protocol/program_error.h"
#include "protocol/time.h"

namespace platon {

/// The medals of a level; nothing if it has none.
using MedalsOf = std::function<std::optional<MedalTimes>(const std::shared_ptr<const Level>& level)>;

/// Whether the match or the recording that the command line names can be played, which decides how the program ends.
struct NamedPlay {
  bool limited = false;                   ///< the program has a time limit
  bool pending = false;                   ///< it has neither been played nor left
  std::optional<ProgramError> failure{};  ///< with which the program ends

  /// What the player has started cannot be played. Returns whether the program ends at once.
  bool fail(const ProgramError& error) {
    if (pending) failure.emplace(error);
    return pending && limited;
  }
  /// Something is played.
  void succeed() {
    pending = false;
    failure.reset();
  }
};

/// What the screens of the game share: the window with its picture and its menu, what keys mean, the settings and the
/// sounds. The screen in front hands its events and frames on to it.
class GameDesk {
 public:
  /// `shownIn` outlives the desk. `openSound` opens the audio device.
  GameDesk(const ClientOptions& options, const Clock& clock, Window& shownIn,
           Audio::Open openSound = &OpenalOutput::open);

  /// `inMenu`: the key belongs to a menu or a replay. Returns what the player asks for.
  std::optional<Action> handle(const KeyEvent& event, bool inMenu);
  /// The repetition of a key of the gamepad, if it is due in this frame. `repeats`: as PadRepeat::repeat.
  std::optional<KeyEvent> repeated(bool repeats, const Frame& frame) { return padRepeat_.repeat(repeats, frame.now); }
  void update(const Frame& frame);
  /// Draws what a setting is judged on while the player changes one that can be judged only in motion and the game, if
  /// there is one, stands still (`still`). Returns whether it has.
  bool drawPreview(bool still, const Frame& frame);
  /// Shows what has been drawn, if it was painted, and saves it if the player has asked for that.
  void present();
  /// Plays the music alone.
  void playMusic(const Frame& frame) { sound.update(nullptr, nullptr, std::nullopt, settings(), frame.seconds); }
  /// Keeps what the program is to leave: the settings, and the picture of the option --screenshot.
  void finish();

  /// Shows the player a short text for a moment.
  void tell(const std::string& text, double seconds = kToldSeconds);
  /// What the picture tells the player for a moment; empty: nothing.
  const std::string& told() const { return told_; }
  /// What a setting is judged on; null while nothing is.
  const SettingsPreview* preview() const { return preview_.get(); }
  Settings& settings() { return interface.settings(); }
  const Settings& settings() const { return interface.settings(); }
  /// Least time from one frame to the next. `calm`: the player does not look at a game that runs.
  Time frameTime(bool calm) const { return frameTimeOf(calm || !window.focused(), settings().frameCap); }

  const ClientOptions options;
  const Clock clock;
  const RecentServers recentServers;
  SettingsFile settingsFile{configFolder()};
  UserInterface interface;
  Window& window;
  GameView view;
  Menu menu;
  SoundFeed sound;
  QualityTrial trial;
  NewPlayerHints hints;
  NamedPlay named;

 private:
  static constexpr double kToldSeconds = 4;

  void fit();

  PadRepeat padRepeat_;
  std::unique_ptr<SettingsPreview> preview_;
  ScreenshotWriter pictures_{picturesFolder()};
  bool pictureAsked_ = false;
  std::string told_;
  double toldSeconds_ = 0;  // for which it is still told
};

}  // namespace platon
