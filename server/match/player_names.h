#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "server/match/shared_bytes.h"

namespace platon {

/// The names of the players of a match by slot. No two of them look alike.
class PlayerNames {
 public:
  /// Names for the slots 0 … `slots` - 1, all of which are free.
  explicit PlayerNames(std::uint32_t slots) : names_(slots), numbers_(slots) {}

  /// Names the player of a free slot: by what can be seen of `wanted`, or by the number of the slot if that is nothing;
  /// with a number if the name of another player looks like it: "Ann", "Ann 2". `wanted` is a label of at most
  /// kMaxNameBytes, and so is the name.
  const std::string& claim(std::uint32_t slot, std::string_view wanted);
  /// Gives the player of a slot another name, as `claim` does. A muted player stays muted.
  const std::string& rename(std::uint32_t slot, std::string_view wanted);
  /// Frees a slot.
  void release(std::uint32_t slot);
  bool isFree(std::uint32_t slot) const { return names_[slot].empty(); }

  /// Shows the player of a slot that is not free by the number of the slot instead of by its name, or by its name
  /// again.
  void mute(std::uint32_t slot, bool muted);
  bool isMuted(std::uint32_t slot) const { return muted_.contains(slot); }
  /// The name by which clients know the player of a slot; empty for a slot that is free.
  const std::string& shown(std::uint32_t slot) const { return numbers_[slot].empty() ? names_[slot] : numbers_[slot]; }

  /// `Roster` messages with all shown names. Encoded once, until a name changes.
  const std::vector<SharedBytes>& all();
  /// `Roster` messages with the shown names that have changed since the last call; an empty name for a slot that is
  /// free.
  std::vector<SharedBytes> takeChanges();

 private:
  std::string reserve(std::string_view base);
  void noteChange(std::uint32_t slot);

  std::vector<std::string> names_;    // by slot; empty: free
  std::vector<std::string> numbers_;  // names of muted players by slot; empty: shown by its name
  std::set<std::uint32_t> muted_;     // slots
  std::set<std::string> taken_;       // look-alike keys of names_ and numbers_
  std::set<std::uint32_t> changed_;   // slots, since the last takeChanges
  std::optional<std::vector<SharedBytes>> all_;
};

}  // namespace platon
