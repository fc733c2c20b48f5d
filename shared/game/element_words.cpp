#include "shared/game/element_words.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "shared/game/level_number.h"

namespace platon {
namespace {

// The number of characters to insert, remove or replace that make `b` of `a`.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j < row.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string hintFor(std::string_view word) {
  constexpr std::size_t longest = 16;  // no word is as long
  const std::size_t farthest = std::min<std::size_t>(2, word.size() / 2);
  if (word.size() <= longest) {
    for (const ElementKind kind : kElementKinds) {
      if (editDistance(word, wordOf(kind)) <= farthest) return "did you mean '" + std::string(wordOf(kind)) + "'?";
    }
  }
  std::string hint = "use";
  for (const ElementKind kind : kElementKinds) hint += (hint == "use" ? " " : ", ") + std::string(wordOf(kind));
  return hint + ", or no word";
}

// Element::number is one byte. A pentagon has the most edges.
static_assert(std::all_of(kElementKinds.begin(), kElementKinds.end(),
                          [](ElementKind kind) { return numbersAfter(kind, 5) <= 256; }));

// What the number after the word means.
std::string_view meaningOf(ElementKind kind) {
  switch (traitsOf(kind).number) {
    case ElementNumber::kNone:
      return {};
    case ElementNumber::kEdge:
      return "the number of an edge of the face";
    case ElementNumber::kDoor:
      return "the number of a door and of its keys and plates";
  }
  return {};
}

std::optional<std::uint8_t> readNumber(const LevelLine& line, const LevelToken& token, ElementKind kind,
                                       std::uint32_t edges, Diagnostics& diagnostics) {
  const std::uint32_t last = numbersAfter(kind, edges) - 1;
  LevelNumber number;
  const bool isNumber = parseNumber(token.text, last, number) == NumberFault::kNone;
  if (isNumber && number.tenThousandths >= 0 && token.text.find('.') == std::string_view::npos)
    return static_cast<std::uint8_t>(number.whole());
  diagnostics.error({line.number, token.column}, std::string(meaningOf(kind)) +
                                                     " must be a whole number between 0 and " + std::to_string(last) +
                                                     ", not " + quoted(token.text));
  return std::nullopt;
}

}  // namespace

std::optional<ElementWord> readElementWord(const LevelLine& line, std::span<const LevelToken> words,
                                           std::uint32_t edges, Diagnostics& diagnostics) {
  const auto kind = elementKindOf(words[0].text);
  if (!kind) {
    diagnostics.error({line.number, words[0].column},
                      "unknown word " + quoted(words[0].text) + ": " + hintFor(words[0].text));
    return std::nullopt;
  }
  const std::size_t wanted = hasNumber(*kind) ? 2 : 1;
  if (words.size() < wanted) {
    diagnostics.error({line.number, line.end},
                      "missing number after '" + std::string(wordOf(*kind)) + "': " + std::string(meaningOf(*kind)));
    return std::nullopt;
  }
  if (words.size() > wanted) {
    diagnostics.error({line.number, words[wanted].column},
                      "unexpected " + quoted(words[wanted].text) + " after " +
                          quoted(std::string(wordOf(*kind)) + (wanted == 2 ? " " + std::string(words[1].text) : "")) +
                          ": remove it");
    return std::nullopt;
  }
  if (wanted == 1) return ElementWord{*kind, 0};
  const auto number = readNumber(line, words[1], *kind, edges, diagnostics);
  return number ? std::optional(ElementWord{*kind, *number}) : std::nullopt;
}

}  // namespace platon
