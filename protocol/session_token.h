#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace platon {

/// The secret by which a client that lost its connection gets its player back: 16 random bytes of its own choice, told
/// to the server with the first greeting. So it works as well when the answer to that was lost.
using SessionToken = std::array<std::uint8_t, 16>;

/// Nothing when the bytes are not as many as a token has.
inline std::optional<SessionToken> tokenOf(std::span<const std::uint8_t> bytes) {
  SessionToken token;
  if (bytes.size() != token.size()) return std::nullopt;
  std::copy(bytes.begin(), bytes.end(), token.begin());
  return token;
}

/// In a time that does not tell how much of a guess was right.
inline bool sameToken(const SessionToken& a, const SessionToken& b) {
  std::uint8_t difference = 0;
  for (std::size_t i = 0; i < a.size(); ++i) difference |= static_cast<std::uint8_t>(a[i] ^ b[i]);
  return difference == 0;
}

}  // namespace platon
