#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "platon/game/level.h"
#include "protocol/to_client.h"
#include "protocol/to_server.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/support/files.h"

namespace platon::fuzz::fuzz_corpus_test {
namespace {

struct Target {
  const char* name;
  std::string (*fault)(Bytes);
};

class FuzzCorpusTest : public testing::TestWithParam<Target> {};

/// The committed inputs together reach what the fuzzers have reached, as CMakeLists.txt counts it.
TEST_P(FuzzCorpusTest, EveryCommittedInputPasses) {
  for (const std::string& file : filesIn(std::string("tests/fuzz/corpus/") + GetParam().name, "")) {
    EXPECT_EQ(GetParam().fault(readBytes(file)), "") << file;
  }
}

TEST_P(FuzzCorpusTest, EmptyAndConstantInputsPass) {
  EXPECT_EQ(GetParam().fault({}), "");
  for (int value = 0; value < 256; ++value) {
    const std::vector<std::uint8_t> bytes(64, static_cast<std::uint8_t>(value));
    EXPECT_EQ(GetParam().fault(bytes), "") << value;
  }
}

// Kinds of messages that a decoder of the target `protocol` finds in the corpus, by their place in the variant.
template <class Message>
std::set<std::size_t> kindsInCorpus(std::size_t decoder, std::optional<Message> (*decode)(Bytes)) {
  std::set<std::size_t> kinds;
  for (const std::string& file : filesIn("tests/fuzz/corpus/protocol", "")) {
    const std::vector<std::uint8_t> content = readBytes(file);
    ByteSource bytes(content);
    if (bytes.below(3) != decoder) continue;
    if (const std::optional<Message> message = decode(bytes.remaining())) kinds.insert(message->index());
  }
  return kinds;
}

// A fuzzer does not invent a message whose layout it has never seen.
TEST(ProtocolCorpus, HasEachMessage) {
  EXPECT_EQ(kindsInCorpus(0, &decodeToServer).size(), std::variant_size_v<ToServer>);
  EXPECT_EQ(kindsInCorpus(1, &decodeToClient).size(), std::variant_size_v<ToClient>);
}

// Nor does it invent the word of an element.
TEST(LevelCorpus, HasEachElement) {
  const std::string folder = "tests/fuzz/corpus/level";
  std::set<ElementKind> kinds;
  for (const std::string& file : filesIn(folder, "")) {
    const LevelResult result = loadLevel(readText(file));
    if (!result.level) continue;
    for (const Element& element : result.level->elements) kinds.insert(element.kind);
  }
  for (const ElementKind kind : kElementKinds)
    EXPECT_TRUE(kinds.contains(kind)) << "add a valid level with '" << wordOf(kind) << "' to " << folder;
}

INSTANTIATE_TEST_SUITE_P(Targets, FuzzCorpusTest,
                         testing::Values(Target{"sweep", &sweepFault}, Target{"scene", &sceneFault},
                                         Target{"level", &levelFault}, Target{"game_state", &gameStateFault},
                                         Target{"recording", &recordingFault}, Target{"protocol", &protocolFault},
                                         Target{"handshake", &handshakeFault}, Target{"channel", &channelFault},
                                         Target{"console", &consoleFault}, Target{"config", &configFault},
                                         Target{"ban_list", &banListFault}, Target{"best_times", &bestTimesFault},
                                         Target{"server_list", &serverListFault}, Target{"settings", &settingsFault}),
                         [](const auto& described) { return std::string(described.param.name); });

}  // namespace
}  // namespace platon::fuzz::fuzz_corpus_test
