#include "client/ui/ball_choice_text.h"

#include <algorithm>
#include <array>
#include <span>

namespace platon {
namespace {

constexpr const char* kAuto = "auto";
constexpr std::array<std::string_view, kBallColours> kColourWords{"orange", "blue", "green", "rose", "cream"};
constexpr std::array<std::string_view, kBallPatterns> kPatterns{"spots", "stripes", "belt",   "cross",
                                                                "dots",  "halves",  "checks", "plain"};

template <class Value>
std::string wordOf(std::optional<Value> value, std::span<const std::string_view> words) {
  return value ? std::string(words[static_cast<std::size_t>(*value)]) : kAuto;
}

template <class Value>
bool parse(std::string_view word, std::optional<Value>& value, std::span<const std::string_view> words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end() && word != kAuto) return false;
  value.reset();
  if (found != words.end()) value = static_cast<Value>(found - words.begin());
  return true;
}

std::string joined(std::span<const std::string_view> words) {
  std::string text = kAuto;
  for (const std::string_view word : words) text += ", " + std::string(word);
  return text;
}

}  // namespace

std::string wordOf(std::optional<std::uint32_t> colour) { return wordOf(colour, std::span(kColourWords)); }
std::string wordOf(std::optional<BallPattern> pattern) { return wordOf(pattern, std::span(kPatterns)); }

bool parse(std::string_view word, std::optional<std::uint32_t>& colour) {
  return parse(word, colour, std::span(kColourWords));
}
bool parse(std::string_view word, std::optional<BallPattern>& pattern) {
  return parse(word, pattern, std::span(kPatterns));
}

std::string ballColourWords() { return joined(kColourWords); }
std::string ballPatternWords() { return joined(kPatterns); }

}  // namespace platon
