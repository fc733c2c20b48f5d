#include "protocol/input_code.h"

#include <gtest/gtest.h>

#include <set>

namespace platon::input_code_test {
namespace {

TEST(InputCodeTest, EveryValidInputHasACodeOfItsOwn) {
  std::set<int> codes;
  for (int byte = 0; byte < 256; ++byte) {
    const Input input{static_cast<std::uint8_t>(byte)};
    if (!isInput(input)) continue;
    const std::uint8_t code = codeOf(input);
    EXPECT_LT(code, 1 << kInputCodeBits) << byte;
    EXPECT_TRUE(codes.insert(code).second) << byte;
    EXPECT_EQ(inputOf(code), input) << byte;
  }
  EXPECT_EQ(codes.size(), 57u);
}

TEST(InputCodeTest, RefusesButtonsWithoutAPlayer) {
  int refused = 0;
  for (int code = 0; code < 1 << kInputCodeBits; ++code) {
    const auto input = inputOf(static_cast<std::uint8_t>(code));
    refused += !input;
    if (input) {
      EXPECT_TRUE(isInput(*input)) << code;
    }
  }
  EXPECT_EQ(refused, 7);
  EXPECT_EQ(inputOf(kAbsentCode), Input());
}

TEST(InputCodeTest, HasTheDocumentedBits) {
  EXPECT_EQ(codeOf({Input::kPresent}), 0);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kRight}), 2);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kLeft | Input::kWalk}), 3);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kRight | Input::kCreep}), 6);
  EXPECT_EQ(codeOf({}), 7);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kJump}), 8);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kDown}), 16);
  EXPECT_EQ(codeOf({Input::kPresent | Input::kRestart}), 32);
}

}  // namespace
}  // namespace platon::input_code_test
