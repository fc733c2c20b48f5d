#include "protocol/session_token.h"

#include <gtest/gtest.h>

#include <vector>

namespace platon::session_token_test {
namespace {

TEST(SessionToken, IsReadFromExactlySixteenBytes) {
  const std::vector<std::uint8_t> bytes = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};
  EXPECT_FALSE(tokenOf(bytes));
  EXPECT_FALSE(tokenOf(std::span(bytes).first(15)));
  EXPECT_EQ(tokenOf(std::span(bytes).first(16)), (SessionToken{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}));
}

TEST(SessionToken, TokensThatDifferInAnyBitAreNotTheSame) {
  const SessionToken token{1, 2, 3};
  EXPECT_TRUE(sameToken(token, SessionToken{1, 2, 3}));
  for (std::size_t bit = 0; bit < 8 * token.size(); ++bit) {
    SessionToken other = token;
    other[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    EXPECT_FALSE(sameToken(token, other)) << bit;
  }
}

}  // namespace
}  // namespace platon::session_token_test
