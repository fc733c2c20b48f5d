#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "client/ui/font.h"

namespace platon {

/// Breaks a text at its spaces into lines that are at most `width` wide, at size 1. A word that is wider is broken
/// between code points; a line has at least one of them.
std::vector<std::string> wrapText(std::string_view utf8, const Font& font, float width);

}  // namespace platon
