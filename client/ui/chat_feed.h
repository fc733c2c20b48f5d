#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace platon {

/// An emote.
struct EmoteText {
  const char* chosen;  ///< what the player chooses
  const char* told;    ///< what the others read after the name
  const char* shown;   ///< in a bubble at the ball
};
/// The emotes in the order of their numbers, from 1 on.
inline constexpr std::array<EmoteText, 4> kEmoteTexts{{{"Wave", "waves", "Hello!"},
                                                       {"Laugh", "laughs", "Ha ha!"},
                                                       {"Here!", "calls: here!", "Here!"},
                                                       {"Thanks", "says thanks", "Thanks!"}}};

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

/// The emotes that players show at their balls.
class EmoteBubbles {
 public:
  static constexpr double kSeconds = 3;  ///< for which one is shown

  /// The player in this slot shows an emote, 1 …, instead of the one before; `seconds`: now, which never decreases.
  void add(std::uint32_t slot, std::uint32_t emote, double seconds);
  /// What the ball of this slot says now; empty: nothing.
  std::string of(std::uint32_t slot, double seconds) const;

 private:
  struct Bubble {
    std::uint32_t emote = 0;
    double until = 0;
  };
  std::map<std::uint32_t, Bubble> bubbles_;  // by slot
};

}  // namespace platon
