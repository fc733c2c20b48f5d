#include "tests/levels/written_solution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<Input> solutionOf(const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / "solution", text);
  return readSolution(folder / "solution");
}

TEST(SolutionTest, ReadsOneInputPerTick) {
  const Input wait{Input::kPresent};
  const Input jump{Input::kPresent | Input::kRight | Input::kJump};
  EXPECT_EQ(solutionOf("# a comment\n\n2 wait\n3 right jump  # over the gap\n1 wait"),
            (std::vector<Input>{wait, wait, jump, jump, jump, wait}));
  EXPECT_EQ(solutionOf("1 left down"), (std::vector<Input>{Input{Input::kPresent | Input::kLeft | Input::kDown}}));
}

TEST(SolutionTest, NamesTheInvalidLine) {
  for (const char* line : {"left 3", "3", "0 left", "3 up", "-"}) {
    EXPECT_THAT([&] { solutionOf(std::string("1 wait\n") + line); },
                ThrowsMessage<std::runtime_error>(HasSubstr("solution:2: ")))
        << line;
  }
  EXPECT_THROW(readSolution("no such file"), std::runtime_error);
}

}  // namespace
}  // namespace platon
