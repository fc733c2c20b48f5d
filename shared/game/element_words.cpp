#include "shared/game/element_words.h"

#include <algorithm>
#include <array>
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

// Element::number has two bytes. A pentagon has the most edges.
static_assert(std::all_of(kElementKinds.begin(), kElementKinds.end(),
                          [](ElementKind kind) { return rangeOf(kind, 5).last <= UINT16_MAX; }));

// What a number after the word means. `index`: of the number.
std::string_view meaningOf(ElementKind kind, std::size_t index) {
  switch (traitsOf(kind).number) {
    case ElementNumber::kNone:
      return {};
    case ElementNumber::kEdge:
      return "the number of an edge of the face";
    case ElementNumber::kDoor:
      return "the number of a door and of its keys and plates";
    case ElementNumber::kTicks:
      return index == 0 ? "the ticks for which it is solid" : "the ticks for which it is open then";
  }
  return {};
}

std::optional<std::uint16_t> readNumber(const LevelLine& line, const LevelToken& token, std::string_view meaning,
                                        NumberRange range, Diagnostics& diagnostics) {
  LevelNumber number;
  const bool isNumber = parseNumber(token.text, range.last, number) == NumberFault::kNone;
  if (isNumber && number.whole() >= range.first && number.tenThousandths >= 0 &&
      token.text.find('.') == std::string_view::npos)
    return static_cast<std::uint16_t>(number.whole());
  diagnostics.error({line.number, token.column}, std::string(meaning) + " must be a whole number between " +
                                                     std::to_string(range.first) + " and " +
                                                     std::to_string(range.last) + ", not " + quoted(token.text));
  return std::nullopt;
}

std::string textOf(std::span<const LevelToken> words) {
  std::string text;
  for (const LevelToken& word : words) text += (text.empty() ? "" : " ") + std::string(word.text);
  return text;
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
  const std::size_t wanted = 1 + numbersOf(*kind);
  if (words.size() < wanted) {
    diagnostics.error({line.number, line.end}, "missing number after " + quoted(textOf(words)) + ": " +
                                                   std::string(meaningOf(*kind, words.size() - 1)));
    return std::nullopt;
  }
  if (words.size() > wanted) {
    diagnostics.error({line.number, words[wanted].column}, "unexpected " + quoted(words[wanted].text) + " after " +
                                                               quoted(textOf(words.first(wanted))) + ": remove it");
    return std::nullopt;
  }
  std::array<std::uint16_t, 2> numbers{};
  for (std::size_t i = 0; i + 1 < wanted; ++i) {
    const auto number = readNumber(line, words[i + 1], meaningOf(*kind, i), rangeOf(*kind, edges), diagnostics);
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return ElementWord{*kind, numbers[0], numbers[1]};
}

}  // namespace platon
