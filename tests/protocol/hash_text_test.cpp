#include "protocol/hash_text.h"

#include <gtest/gtest.h>

namespace platon::hash_text_test {
namespace {

TEST(HashText, HasSixteenDigitsAndIsReadAgain) {
  EXPECT_EQ(hashText(0), "0000000000000000");
  EXPECT_EQ(hashText(0x31305b9e599e880fU), "31305b9e599e880f");
  for (const std::uint64_t hash : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}})
    EXPECT_EQ(hashIn(hashText(hash)), hash);
}

TEST(HashText, NothingElseIsAHash) {
  for (const char* text : {"", "0", "31305B9E599E880F", "31305b9e599e880", "31305b9e599e880f0", " 1305b9e599e880f",
                           "31305b9e599e880g", "0x305b9e599e880f"})
    EXPECT_EQ(hashIn(text), std::nullopt) << text;
}

}  // namespace
}  // namespace platon::hash_text_test
