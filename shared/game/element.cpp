#include "platon/game/element.h"

#include <algorithm>
#include <tuple>

#include "platon/exact/integer.h"
#include "shared/game/level_number.h"

namespace platon {

std::optional<ElementKind> elementKindOf(std::string_view word) {
  const auto found = std::find_if(kElementKinds.begin(), kElementKinds.end(),
                                  [word](ElementKind kind) { return wordOf(kind) == word; });
  return found == kElementKinds.end() ? std::nullopt : std::optional(*found);
}

std::string ElementWord::text() const {
  std::string text(wordOf(kind));
  if (numbersOf(kind) > 0) text += " " + std::to_string(number);
  if (numbersOf(kind) > 1) text += " " + std::to_string(openTicks);
  return text;
}

bool isAmong(std::span<const ElementWord> words, const Element& element) {
  return std::any_of(words.begin(), words.end(), [&](ElementWord word) { return word.isOf(element); });
}

std::optional<ElementWord> needOf(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  const auto kind = elementKindOf(text.substr(0, end));
  if (!kind) return std::nullopt;
  if (isCheckpoint(*kind) && end == text.size()) return ElementWord{*kind, 0};
  if (!opensDoors(*kind) || end == text.size()) return std::nullopt;
  const std::string_view digits = text.substr(std::min(text.find_first_not_of(blanks, end), text.size()));
  LevelNumber number;
  if (parseNumber(digits, kMaxDoorNumbers - 1, number) != NumberFault::kNone ||
      digits.find_first_of("-.") != std::string_view::npos)
    return std::nullopt;
  return ElementWord{*kind, static_cast<std::uint16_t>(number.whole())};
}

const Element* findElement(std::span<const Element> elements, std::uint32_t face, std::uint32_t segment) {
  const auto found = std::lower_bound(elements.begin(), elements.end(), std::tuple(face, segment),
                                      [](const Element& element, const std::tuple<std::uint32_t, std::uint32_t>& key) {
                                        return std::tuple(element.face, element.segment) < key;
                                      });
  return found != elements.end() && found->face == face && found->segment == segment
             ? elements.data() + (found - elements.begin())
             : nullptr;
}

bool pointsTo(Angle up, const Element& element, std::int32_t edgesPerFace) {
  const std::int32_t apart = Angle::kTurn / edgesPerFace;
  // Edge 0 is at the bottom.
  const Angle fromEdge = up - Angle(Angle::kTurn / 2 + element.number * apart) + Angle(apart / 2);
  return fromEdge.centidegrees() < apart;
}

Point placeOf(const Element& checkpoint) {
  const auto [a, b] = checkpoint.ends;
  return {divideRounded(a.x + b.x, 2), divideRounded(a.y + b.y, 2)};
}

}  // namespace platon
