#pragma once

#include <array>
#include <bitset>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/demo/demo.h"
#include "client/lobby/shipped_levels.h"
#include "client/menu/pages/settings_pages.h"
#include "client/play/game_desk.h"
#include "client/play/match/live_match.h"
#include "client/play/match_pages.h"
#include "client/play/screen.h"
#include "client/ui/controls/input_mapper.h"
#include "client/ui/spectator.h"

namespace platon {

/// A match in the window of the program, with the pages over it. Why it has ended is shown here if the server has let
/// the player in, and otherwise by the screen behind it.
class MatchScreen : public Screen {
 public:
  /// Starts the match. Throws as LiveMatch. `desk` outlives the screen.
  MatchScreen(GameDesk& desk, const MatchChoice& choice, MedalsOf medalsOf);

  Next handle(const WindowEvent& event) override;
  Next update(const Frame& frame) override;
  void draw(const Frame& frame) override;
  Time frameTime() const override { return desk_->frameTime(desk_->menu.isOpen()); }
  Image read() const override { return desk_->view.read(); }
  /// The game goes on, and comes to the front when somebody joins.
  bool updateBehind(const Frame& frame) override;
  Next reveal(const Ending& ending) override;
  void leave() override { match_.leave(); }

  const LiveMatch& match() const { return match_; }

 private:
  enum class Phase { kJoining, kPlaying, kEnded };

  void handleKey(const KeyEvent& event);
  void handlePointer(const PointerEvent& event);
  void perform(Action action, const KeyEvent& event);
  void wishNext();
  void tellJoin(Key key);
  std::string secondKeysText() const;
  void followDevices();
  void watch(const std::filesystem::path& file);
  void stopWatching(const ReplayEnd& end);
  void advance(bool away);
  Input choose(const Game& game, std::uint32_t slot, bool away);
  void checkEnding();
  std::vector<Scene> scenes();
  HudStatus hudStatus(std::span<const Scene> seen);
  std::string hint(bool roundOver) const;
  std::optional<MedalTimes> medals(const Scene& scene);
  void playSounds(const Scene* scene, const HudStatus& status, double seconds);

  GameDesk* desk_;
  MatchChoice choice_;
  MedalsOf medalsOf_;
  LiveMatch match_;
  Phase phase_ = Phase::kJoining;
  SettingsPages settingsPages_;
  MatchPages pages_;
  bool sayAsked_ = false;
  Demo demo_{shippedWay};
  std::array<Steering, kMaxLocalPlayers> steering_;  // by local number, as the next one
  std::bitset<kMaxLocalPlayers> joined_;             // companions of which the match knows
  MouseLook mouseLook_;
  bool looks_ = false;  // the player turns the view, in the last frame
  Spectator spectator_;
  bool againTogether_ = false;  // after the round, the first player takes all of this machine back to the start
  SkipQuestion skip_;
  NetMeter meter_;
  std::optional<std::optional<MedalTimes>> medals_;  // of the level, while the player is at its goal
  Next next_;
};

/// The menu item that joins the server where another one has told to go on, by `start`; nothing if it has told none.
/// The player decides, because any server can name any other. It gets no password.
std::optional<MenuItem> joinItem(const std::optional<ServerAddress>& next,
                                 const std::function<void(const MatchChoice&)>& start);

}  // namespace platon
