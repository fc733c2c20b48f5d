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
  explicit PlayerNames(std::uint32_t slots) : names_(slots) {}

  /// Names the player of a free slot: by what can be seen of `wanted`, or by the number of the slot if that is nothing;
  /// with a number if the name of another player looks like it: "Ann", "Ann 2". `wanted` is a label of at most
  /// kMaxNameBytes, and so is the name.
  const std::string& claim(std::uint32_t slot, std::string_view wanted);
  /// Frees a slot.
  void release(std::uint32_t slot);
  bool isFree(std::uint32_t slot) const { return names_[slot].empty(); }

  /// `Roster` messages with all names. Encoded once, until a name changes.
  const std::vector<SharedBytes>& all();
  /// `Roster` messages with the names that have changed since the last call; an empty name for a slot that is free.
  std::vector<SharedBytes> takeChanges();

 private:
  void change(std::uint32_t slot, std::string name);

  std::vector<std::string> names_;   // by slot; empty: free
  std::set<std::u32string> taken_;   // look-alike keys of the names
  std::set<std::uint32_t> changed_;  // slots, since the last takeChanges
  std::optional<std::vector<SharedBytes>> all_;
};

}  // namespace platon
