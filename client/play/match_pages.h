#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include "client/menu/menu.h"
#include "client/menu/text_field.h"
#include "client/play/match/live_match.h"
#include "client/ui/user_interface.h"
#include "protocol/chat.h"

namespace platon {

/// Asks a player who is alone once more before it leaves a level whose goal it has not reached.
class SkipQuestion {
 public:
  /// The player wishes the next level. Returns whether to go there: at once if the goal is `reached`, else when the
  /// player wishes it a second time.
  bool wish(bool reached) { return std::exchange(asked_, !reached && !asked_) || reached; }
  /// The player does something else.
  void takeBack() { asked_ = false; }
  /// Whether the question is open.
  bool asked() const { return asked_; }

 private:
  bool asked_ = false;
};

/// The pages over a match: the pause, and the one to say something to the others.
class MatchPages {
 public:
  struct Calls {
    std::function<void()> showSettings;
    std::function<void()> leave;                              ///< the match, to the title
    std::function<void(const std::filesystem::path&)> watch;  ///< a recording
    std::function<void(const std::string&)> tell;             ///< shows the player a short text
  };

  /// `menu` and `interface` outlive the pages.
  MatchPages(Menu& menu, UserInterface& interface, Calls calls);

  /// Shows the pause instead of all other pages. The match exists as long as the page is shown.
  void showPause(LiveMatch& match);
  /// Call when the gamepad that the player uses was disconnected: shows the pause to a player who is alone and has no
  /// page open, and tells the others, whose game goes on.
  void loseGamepad(LiveMatch& match);
  /// Shows the page to say something instead of all other pages. The match exists as long as the page is shown.
  void showSay(LiveMatch& match);
  /// Closes all pages and says something, or tells the player that it has said too much.
  void say(LiveMatch& match, const Chat& chat, std::uint32_t local = 0);

 private:
  void openPause(LiveMatch& match, const std::string& note);
  MenuPage pauseOver(LiveMatch& match, const std::string& note);

  Menu* menu_;
  UserInterface* interface_;
  Calls calls_;
  SkipQuestion skip_;
  TextField text_{kMaxChatBytes};  // what the player is about to say
};

}  // namespace platon
