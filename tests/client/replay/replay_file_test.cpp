#include "client/replay/replay_file.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon {
namespace {

TEST(ReplayFile, IsRead) {
  const auto replay = readReplay("tests/determinism/golden/hexahedron.recording");
  ASSERT_TRUE(std::holds_alternative<std::shared_ptr<const Replay>>(replay));
  EXPECT_GE(std::get<std::shared_ptr<const Replay>>(replay)->ticks(), 1800U);
}

TEST(ReplayFile, AFaultNamesTheFile) {
  const TemporaryFolder folder;
  const std::string missing = (folder / "missing").string();
  const auto none = readReplay(missing);
  EXPECT_EQ(std::get<std::string>(none), missing + ": cannot be read: No such file or directory");
  const std::string text = (folder / "text").string();
  writeText(text, "no recording");
  const auto other = readReplay(text);
  EXPECT_EQ(std::get<std::string>(other),
            text + ": cannot be played: byte 0: not a recording, or an unsupported version");
}

}  // namespace
}  // namespace platon
