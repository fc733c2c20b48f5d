#pragma once

#include <set>
#include <string>
#include <string_view>

namespace platon {

/// The names of the players of a match. No two of them look alike.
class PlayerNames {
 public:
  /// A name for a new player: what can be seen of `wanted`, or `substitute` if that is nothing, with a number if the
  /// name of another player looks like it: "Ann", "Ann 2". Both arguments are labels of at most kMaxNameBytes, and so
  /// is the result. It belongs to the player until `release`.
  std::string claim(std::string_view wanted, std::string_view substitute);
  /// Call when a player with this name, which `claim` has returned, leaves or takes another name.
  void release(std::string_view name);

 private:
  std::set<std::u32string> taken_;  // look-alike keys
};

}  // namespace platon
