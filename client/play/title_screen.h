#pragma once

#include <filesystem>
#include <optional>

#include "client/menu/pages/levels_page.h"
#include "client/play/front_pages.h"
#include "client/play/game_desk.h"
#include "client/play/screen.h"

namespace platon {

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
  Next reveal(const Ending& ending) override;
  void leave() override { desk_->finish(); }

 private:
  void handleKey(const KeyEvent& event);
  void start(const MatchChoice& choice);
  void refuse(const MatchRefused& refused);
  void leaveMatch();
  void watch(const std::filesystem::path& file);
  void stopWatching(const ReplayEnd& end);
  MedalsOf medals();
  void drawMenu(const Frame& frame);

  GameDesk* desk_;
  FrontPages front_;
  Turntable turntable_;
  MatchChoice choice_;  // the last one
  Next next_;
};

}  // namespace platon
