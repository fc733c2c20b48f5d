#include "client/ui/text_wrap.h"

#include <algorithm>

#include "platon/game/utf8.h"

namespace platon {
namespace {

// Removes the text up to the next space, and that space.
std::string_view takeWord(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find(' '));
  text.remove_prefix(std::min(word.size() + 1, text.size()));
  return word;
}

// Removes as many code points as are at most `width` wide together, but at least one.
std::string_view takePart(std::string_view& word, const Font& font, float width) {
  std::string_view rest = word;
  takeCodePoint(rest);
  while (!rest.empty()) {
    std::string_view next = rest;
    takeCodePoint(next);
    if (font.width(word.substr(0, word.size() - next.size())) > width) break;
    rest = next;
  }
  const std::string_view part = word.substr(0, word.size() - rest.size());
  word = rest;
  return part;
}

}  // namespace

std::vector<std::string> wrapText(std::string_view utf8, const Font& font, float width) {
  std::vector<std::string> lines;
  while (!utf8.empty()) {
    std::string_view word = takeWord(utf8);
    if (word.empty()) continue;
    if (!lines.empty() && font.width(lines.back() + ' ' + std::string(word)) <= width) {
      lines.back().append(" ").append(word);
      continue;
    }
    while (!word.empty()) lines.emplace_back(takePart(word, font, width));
  }
  return lines;
}

}  // namespace platon
