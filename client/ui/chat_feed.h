#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

namespace platon {

/// The emotes in the order of their numbers, from 1 on: what the player chooses, and what the others read after the
/// name.
inline constexpr std::array<std::pair<const char*, const char*>, 4> kEmoteNames{
    {{"Wave", "waves"}, {"Laugh", "laughs"}, {"Here!", "calls: here!"}, {"Thanks", "says thanks"}}};

/// What players have said lately, as lines of text.
class ChatFeed {
 public:
  static constexpr double kSeconds = 8;        ///< for which a line is shown
  static constexpr std::size_t kMaxLines = 5;  ///< at a time; the oldest are dropped

  /// A player with this name says a text, or an emote, 1 …; `seconds`: now, which never decreases.
  void add(const std::string& name, const std::string& text, std::uint32_t emote, double seconds);
  /// The lines to show now, oldest first.
  std::vector<std::string> lines(double seconds) const;
  /// The last lines whatever their age, newest first.
  std::vector<std::string> newest() const;

 private:
  struct Line {
    std::string text;
    double until = 0;
  };
  std::deque<Line> lines_;
};

}  // namespace platon
