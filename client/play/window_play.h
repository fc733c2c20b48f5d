#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "client/demo/demo.h"
#include "client/files/settings_file.h"
#include "client/files/user_folders.h"
#include "client/gl/game_view.h"
#include "client/gl/screenshot_writer.h"
#include "client/gl/window.h"
#include "client/lobby/shipped_levels.h"
#include "client/menu/menu.h"
#include "client/menu/pages/settings_pages.h"
#include "client/menu/pages/turntable.h"
#include "client/play/client_options.h"
#include "client/play/front_pages.h"
#include "client/play/match/live_match.h"
#include "client/play/match/net_meter.h"
#include "client/play/match/sound_feed.h"
#include "client/play/match_pages.h"
#include "client/play/replay_play.h"
#include "client/play/settings_preview.h"
#include "client/quality/quality_trial.h"
#include "client/time/clock.h"
#include "client/ui/controls/mouse_look.h"
#include "client/ui/controls/pad_repeat.h"
#include "client/ui/hints/new_player_hints.h"
#include "client/ui/skip_question.h"
#include "client/ui/spectator.h"
#include "client/ui/steering.h"
#include "client/ui/user_interface.h"
#include "protocol/moment.h"
#include "protocol/program_error.h"

namespace platon {

/// The game in a window: title, matches, replays, menus. What goes wrong is shown on the screen, where the player can
/// try again or go back.
class WindowPlay {
 public:
  /// Starts what the options name, or shows the title. Throws ProgramError if no window can be opened.
  WindowPlay(const ClientOptions& options, const Clock& clock);

  /// Runs until the player leaves, the time limit of the options is reached or `stopRequested` returns true. Throws
  /// ProgramError at the end if what the options name could not be played, and at once if they have a time limit.
  void run(const std::function<bool()>& stopRequested);

  const Menu& menu() const { return menu_; }
  /// The present match; null if there is none.
  const LiveMatch* match() const { return match_ ? &*match_ : nullptr; }
  /// The recording that is shown; null if there is none.
  const ReplayPlay* replay() const { return replay_ ? &*replay_ : nullptr; }
  /// What the picture tells the player for a moment; empty: nothing.
  std::string told() const { return drawnAt_ < toldUntil_ ? told_ : std::string(); }
  /// What a setting is judged on; null while nothing is.
  const SettingsPreview* preview() const { return preview_ ? &*preview_ : nullptr; }

 private:
  static constexpr Moment kToldTime = std::chrono::seconds(4);

  bool shouldContinue(Moment now) const;

  // Events.
  void handleEvents();
  void handle(const KeyEvent& event);
  void handle(const PointerEvent& event);
  void tell(const std::string& text, Moment time = kToldTime);
  Input choose(const Game& game, std::uint32_t slot);
  void wishNext();

  // Recordings.
  void takeDrops();
  void watch(const std::filesystem::path& file);
  void updateReplay(double seconds);
  void leaveReplay(const std::filesystem::path& file);
  void failReplay();

  // Matches.
  void start(const MatchChoice& choice);
  void updateMatch();
  void checkEnding();
  void fail(const ProgramError& error);
  void failMatch(const std::string& title, const std::string& reason);
  std::optional<MenuItem> goOn();
  void leaveToTitle();
  void leaveMatch();

  void draw(Moment now);
  void playSounds(const Scene* scene, const HudStatus& status, double seconds);
  bool showsPreview() const;
  void drawPreview(double seconds);
  void drawReplay(double seconds);
  void drawMatch(double seconds);
  void savePicture();
  std::string hint(bool roundOver) const;
  std::string medal(const Scene& scene);
  void drawFront(double seconds);
  void takeScreenshot();

  ClientOptions options_;
  Clock clock_;
  SettingsFile settingsFile_{configFolder()};
  UserInterface interface_;
  Window window_;
  GameView view_;
  Menu menu_;
  SettingsPages settingsPages_{menu_, interface_.settings(), [this] { return !match_ || match_->alone(); }};
  FrontPages front_;
  MatchPages matchPages_{
      menu_,
      interface_,
      {[this] { settingsPages_.show(MenuPage::Place::kMiddle); }, [this] { leaveToTitle(); },
       [this](const std::filesystem::path& file) { watch(file); }, [this](const std::string& text) { tell(text); }}};
  Turntable turntable_;
  MatchChoice choice_;                 // the last one
  std::optional<ServerAddress> next_;  // where its server has told to go on after its end
  std::optional<LiveMatch> match_;
  std::optional<ReplayPlay> replay_;                 // shown in front of a match
  std::optional<std::optional<MedalTimes>> medals_;  // of the level: of the replay, or while the player is at its goal
  std::optional<SettingsPreview> preview_;           // while a setting is judged on it
  QualityTrial trial_;
  Steering steering_;
  MouseLook mouseLook_;
  PadRepeat padRepeat_;
  NewPlayerHints hints_;
  Spectator spectator_;
  SkipQuestion skip_;
  Demo demo_{shippedWay};
  NetMeter meter_;
  ScreenshotWriter pictures_{picturesFolder()};
  SoundFeed sound_;
  std::optional<ProgramError> failure_;  // of what the options name
  bool named_ = false;                   // the match or the recording is what the options name
  bool endingShown_ = false;
  bool remembered_ = false;
  bool leaving_ = false;
  std::string told_;  // to the player, for a moment
  Moment toldUntil_{};
  Moment startedAt_;
  Moment drawnAt_;
};

}  // namespace platon
