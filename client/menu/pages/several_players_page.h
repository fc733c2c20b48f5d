#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "client/menu/menu_page.h"
#include "client/menu/pages/levels_page.h"
#include "client/menu/text_field.h"
#include "client/ui/settings.h"

namespace platon {

/// What is offered of a level that needs several players.
struct SeveralPlayersChoices {
  std::function<void()> playHere;
  std::function<void()> host;
  std::function<void()> join;
};

/// The page of a level that cannot be played alone: why, and what the player can do instead.
MenuPage severalPlayersPage(const LevelEntry& level, const SeveralPlayersChoices& choices);

/// What the player enters to host a game.
struct HostForm {
  HostForm();

  std::size_t level = 0;   ///< the first level that is played, an index into the levels
  bool onlyLevel = false;  ///< no other is played
  double players = 8;      ///< at most so many, 1 … 64
  TextField port{5};
  TextField password{128};
  std::string fault{};  ///< what is wrong with the form; empty: nothing
};

/// Items of the page to host a game that the program may give the focus to.
inline constexpr std::size_t kHostPortItem = 3;
inline constexpr std::size_t kHostStartItem = 5;

/// The page on which the player sets up a game for others. `host` is called with the present form. `form` and `levels`
/// outlive the page.
MenuPage hostPage(HostForm& form, std::span<const LevelEntry> levels, const std::function<void()>& host);

/// What the player enters to join a server.
struct JoinForm {
  struct Found {
    std::string name;
    std::string address;
    std::string about;  ///< players, round-trip time, what keeps a player out
  };

  TextField address{128};
  TextField password{128};
  bool asksPassword = false;            ///< the server has asked for a password
  std::string fault{};                  ///< what is wrong with the address or the password; empty: nothing
  std::vector<std::string> recent{};    ///< addresses of servers that were joined, the newest first
  std::vector<Found> found{};           ///< servers that answer: those nearby and those of a list
  TextField listUrl{kMaxListUrlBytes};  ///< of a list of servers; empty: none
  bool asksList = true;                 ///< the player may change listUrl
  bool hasList = false;                 ///< there is a list
  std::string listFault{};              ///< why the list, or a server in it, is left out; empty: it is not
};

/// The item for JoinForm::listUrl, where the form asks for it.
std::size_t itemOfList(const JoinForm& form);

/// The page on which the player enters the address of a server. `join` is called with the present form. `form` outlives
/// the page.
MenuPage joinPage(JoinForm& form, const std::function<void()>& join);

}  // namespace platon
