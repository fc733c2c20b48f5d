#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace platon {

/// Secret with which a client resumes its players after its connection was lost: 16 random bytes that the client
/// chooses and sends in its first `Hello`. It works even when the answer to that message is lost.
using SessionToken = std::array<std::uint8_t, 16>;

/// Returns nothing if the number of bytes is not that of a token.
inline std::optional<SessionToken> tokenOf(std::span<const std::uint8_t> bytes) {
  SessionToken token;
  if (bytes.size() != token.size()) return std::nullopt;
  std::copy(bytes.begin(), bytes.end(), token.begin());
  return token;
}

/// Compares in constant time, so that timing does not reveal how many bytes of a guess are right.
inline bool sameToken(const SessionToken& a, const SessionToken& b) {
  std::uint8_t difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<std::uint8_t>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace platon
