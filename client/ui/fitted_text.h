#pragma once

#include <string>
#include <string_view>

#include "client/ui/font.h"

namespace platon {

/// The text if it is at most `width` wide at size 1, or else its longest beginning that is with an ellipsis.
std::string fittedText(std::string_view text, const Font& font, float width);

}  // namespace platon
