#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"
#include "client/ui/settings.h"

namespace platon {

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
