#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "platon/game/game.h"

namespace platon {

/// Searches what one player can do from a state of the game while the others wait: all ways of pressing buttons, tick
/// by tick on a copy of the game, the cheapest ones first. A way costs its ticks and its presses of buttons. States
/// that are nearly equal count as one. So it finds short ways, not always the shortest, and may miss one that depends
/// on a subunit.
class WaySearch {
 public:
  /// What a way leads to.
  struct Target {
    enum class Kind : std::uint8_t { kGoal, kKey, kPlate };

    Kind kind = Kind::kGoal;
    std::uint32_t element = 0;  ///< index into Level::elements of a key or plate

    friend auto operator<=>(const Target&, const Target&) = default;  // NOLINT(modernize-use-nullptr)
  };
  struct Limits {
    std::size_t states = 6000000;            ///< most states that are kept
    std::optional<std::uint32_t> crossings;  ///< most crossings of a way
    std::uint32_t pressCost = 0;             ///< of each press of a button, in ticks
    std::vector<ElementWord> without = {};   ///< keys, plates or checkpoints that a way does not touch
    std::function<bool()> stop = {};         ///< asked every few milliseconds by find and findAll; true: they end
    /// Estimates the ticks that are left from a state, for a search that finds some way sooner, not a short one.
    std::function<std::uint32_t(const Game& game)> ticksLeft = {};
  };

  /// Searches for `slot` from `start`, in which its player is present.
  WaySearch(const Game& start, std::uint32_t slot, const Limits& limits);
  WaySearch(const Game& start, std::uint32_t slot) : WaySearch(start, slot, Limits()) {}

  /// Simulates about this many further ticks. Returns whether anything is left to search.
  bool work(std::uint64_t ticks);
  /// Searches until the target is found, nothing is left, or Limits::stop. Returns whether it was found.
  bool find(const Target& target);
  /// Searches until nothing is left, or Limits::stop.
  void findAll();

  /// The targets found so far.
  const auto& found() const { return found_; }
  /// The inputs of the player's slot that lead to a target that was found.
  std::vector<Input> inputsTo(const Target& target) const;
  std::size_t states() const { return nodes_.size(); }

 private:
  struct Node {
    std::uint32_t parent = 0;
    std::uint32_t cost = 0;
    std::uint64_t signature = 0;
    std::uint8_t buttons = 0;         // held from the parent to this node
    std::vector<std::uint8_t> state;  // saved game; empty once expanded
  };
  struct Way {
    std::uint32_t parent = 0;
    std::uint8_t buttons = 0;
    std::uint32_t ticks = 0;  // from the parent
  };

  bool workOn();
  std::uint32_t takeCheapest();
  void expand(std::uint32_t index);
  void keep(std::uint32_t parent, std::uint8_t buttons);
  bool simulate(std::uint32_t parent, std::uint8_t buttons);
  bool keepsOff() const;
  void noteTargets(const Way& way);
  void note(const Target& target, const Way& way) { found_.emplace(target, way); }
  std::uint64_t signature() const;

  Game game_;  // scratch for simulation
  std::uint32_t slot_;
  Limits limits_;
  std::uint32_t crossingsBefore_;
  std::vector<Input> inputs_;
  std::vector<Node> nodes_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> open_;  // not expanded, by cost and ticks left
  std::unordered_map<std::uint64_t, std::uint32_t> costs_;    // lowest cost by signature
  std::map<Target, Way> found_;
};

}  // namespace platon
