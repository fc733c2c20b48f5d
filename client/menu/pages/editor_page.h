#pragma once

#include <functional>
#include <string>
#include <vector>

#include "client/menu/menu_page.h"
#include "client/menu/text_field.h"
#include "platon/game/solid.h"

namespace platon {

/// What the player enters to make a level, and the levels that it has made.
struct EditForm {
  TextField name{64};                        ///< of a new level
  SolidKind solid = SolidKind::kHexahedron;  ///< of a new level
  std::string folder{};                      ///< where the levels are
  std::vector<std::string> files{};          ///< names of the level files there
  std::string fault{};                       ///< why no level can be made or edited; empty: it can
};

/// The file name for a level of this name: letters, digits, `-` and `_` for spaces, with `.level`. Empty if nothing of
/// the name is left.
std::string levelFileNameOf(const std::string& name);

/// The page that leads to the level editor. `create` is called with the present form, `edit` with one of its files.
/// `form` outlives the page.
MenuPage editorPage(EditForm& form, const std::function<void()>& create,
                    const std::function<void(const std::string& file)>& edit);

}  // namespace platon
