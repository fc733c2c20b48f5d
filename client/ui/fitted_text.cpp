#include "client/ui/fitted_text.h"

#include "platon/game/utf8.h"

namespace platon {

std::string fittedText(std::string_view text, const Font& font, float width) {
  if (font.width(text) <= width) return std::string(text);
  std::string fitted;
  std::string_view rest = text;
  while (!rest.empty()) {
    takeCodePoint(rest);
    std::string longer = std::string(text.substr(0, text.size() - rest.size())) + "…";
    if (font.width(longer) > width) break;
    fitted = std::move(longer);
  }
  return fitted;
}

}  // namespace platon
