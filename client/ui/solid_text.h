#pragma once

#include <string>

#include "platon/game/solid.h"

namespace platon {

/// What players are told of a solid: its name and the element that Plato's Timaeus gives it, "Cube · earth". Level
/// files and the command line have `nameOf`.
std::string textOf(SolidKind solid);

}  // namespace platon
