#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "protocol/time.h"
#include "tests/net/attacks/attack_network.h"

namespace platon {

/// An attack that runs.
class Attacker {
 public:
  virtual ~Attacker() = default;
  /// Called every millisecond; sends at most about this many datagrams.
  virtual void step(Time now, int datagrams) = 0;
};

/// A kind of attack on a server.
struct Attack {
  std::string_view name;  ///< one word with hyphens
  std::string_view does;  ///< for the table in docs/security.md
  /// Whether the attacker answers at his addresses. Otherwise none of them has returned a cookie, so that none may hold
  /// a place or be sent more than it sent.
  bool proves = false;
  /// A reason for which the server must reject some of what it sends, so that the attack is known to reach it; empty:
  /// none is rejected.
  std::string_view reason;
  std::function<std::unique_ptr<Attacker>(AttackNetwork&)> start;
  IpVersion version = IpVersion::kIpv4;
  /// Whether the attacker sends little in order to be sent much. In kAmplifyingLasts after kAmplifyingBegins he may be
  /// sent at most kMaxAmplification times the bytes that he sends, ticks aside.
  bool amplifies = false;
};

inline constexpr Time kAmplifyingBegins = std::chrono::seconds(10);
inline constexpr Time kAmplifyingLasts = std::chrono::seconds(20);
inline constexpr std::uint64_t kMaxAmplification = 4;

/// All of them. The tests and `./platon bench --attacks` run the same.
std::span<const Attack> attacks();

}  // namespace platon
