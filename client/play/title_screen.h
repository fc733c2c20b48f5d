#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "client/demo/stroll.h"
#include "client/menu/pages/levels_page.h"
#include "client/play/editor_screen.h"
#include "client/play/front_pages.h"
#include "client/play/game_desk.h"
#include "client/play/offscreen/local_game.h"
#include "client/play/screen.h"

namespace platon {

/// The game beside the pages before a match: a ball rolls about on a level, without solving it.
class TitleGame {
 public:
  static constexpr std::uint32_t kMaxTicks = 15;  ///< of one picture: a late one is not made up for

  /// Plays this level from now on, from its start. No effect if it does already.
  void show(const std::shared_ptr<const Level>& level);
  bool shows() const { return game_.has_value(); }
  /// Plays on for `seconds`, but at most kMaxTicks. Requires a level, as `scene` does.
  void advance(double seconds);
  Scene scene(const BallChoice& ball) const { return game_->scene(ball); }
  const Game& game() const { return game_->game(); }

 private:
  void begin();

  std::optional<LocalGame> game_;
  Stroll stroll_;
  double due_ = 0;  // ticks to be played
};

/// The title and the pages before a match, beside the solid of a level. It starts matches and recordings in front of
/// itself; what goes wrong with them is shown here, where the player can try again or go back.
class TitleScreen : public Screen {
 public:
  /// Starts what the options name, or shows the title. `desk` outlives the screen.
  explicit TitleScreen(GameDesk& desk);

  Next handle(const WindowEvent& event) override;
  Next update(const Frame& frame) override;
  void draw(const Frame& frame) override;
  Time frameTime() const override { return desk_->frameTime(true); }
  Image read() const override { return desk_->view.read(); }
  Next reveal(const Ending& ending) override;
  void leave() override { desk_->finish(); }

 private:
  void handleKey(const KeyEvent& event);
  void start(const MatchChoice& choice);
  void refuse(const MatchRefused& refused);
  void leaveMatch();
  void watch(const std::filesystem::path& file);
  void stopWatching(const ReplayEnd& end);
  void edit(const std::filesystem::path& file, SolidKind solid);
  MedalsOf medals();
  void drawMenu(const Frame& frame);

  GameDesk* desk_;
  FrontPages front_;
  TitleGame game_;
  Turntable turntable_;
  MatchChoice choice_;                  // the last one
  std::optional<EditSession> session_;  // of the editor in front of the title; nothing: there is none
  Next next_;
};

}  // namespace platon
