#pragma once

#include <optional>
#include <string_view>

#include "client/ui/key.h"

namespace platon {

/// What the player reads on the key or button: `Space`, `←`, `LB`.
std::string_view shownNameOf(Key key);

/// The name of the key in the settings file: `space`, `arrow-left`, `pad-lb`. Empty for keys that no control can have:
/// those of the menus and of the program, and what is only a tilt of a stick.
std::string_view wordOf(Key key);

/// The key with this name in the settings file.
std::optional<Key> keyNamed(std::string_view word);

/// Whether a control of the game can have the key.
inline bool canBeBound(Key key) { return !wordOf(key).empty(); }

}  // namespace platon
