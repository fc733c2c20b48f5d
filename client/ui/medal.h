#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <glm/vec4.hpp>

namespace platon {

/// A judgement of a time to the goal. The game does not know of it.
enum class Medal : std::uint8_t { kNone, kBronze, kSilver, kGold };

/// Longest times to the goal that give the medals of a level, in ticks.
struct MedalTimes {
  std::uint32_t gold = 0;
  std::uint32_t silver = 0;
  std::uint32_t bronze = 0;
};

/// The medals of a level on which an easy way takes so many ticks: gold for 1.15 of its time, silver for 1.5, bronze
/// for 2.5, each rounded up to a tenth of a second.
MedalTimes medalTimesOf(std::uint32_t wayTicks);

/// The best medal that a time gives.
Medal medalFor(const MedalTimes& times, std::uint32_t ticks);

/// Three stars, as many of them filled as the medal counts: ★★★ is gold, ☆☆☆ none. Nothing: one star, for a time on a
/// level without medals.
std::string starsOf(std::optional<Medal> medal);
/// The colour of the medal; that of soft text without one.
glm::vec4 colourOf(Medal medal);

/// What a time has given, and what is next: `★★☆ silver, gold: 12.30 s`; without a medal only that: `bronze: 31.50 s`.
std::string medalText(const MedalTimes& times, std::uint32_t ticks);

/// The next better medal and its time: `gold: 12.30 s`; `gold` if it has been reached. `best`: nothing: no time yet.
std::string nextMedalText(const MedalTimes& times, std::optional<std::uint32_t> best);

}  // namespace platon
