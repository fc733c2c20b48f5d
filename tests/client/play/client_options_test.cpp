#include "client/play/client_options.h"

#include <gtest/gtest.h>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "protocol/program_error.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace platon::client_options_test {
namespace {

std::optional<ClientOptions> read(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "platon-client");
  return readClientOptions(static_cast<int>(arguments.size()), arguments.data());
}

// Exit code and message.
std::string fault(const std::vector<const char*>& arguments) {
  try {
    read(arguments);
    return "none";
  } catch (const ProgramError& error) {
    return std::to_string(error.exitCode()) + " " + error.what();
  }
}

TEST(ClientOptions, DefaultToAnEmbeddedServerAndAWindow) {
  const auto options = read({});
  ASSERT_TRUE(options);
  EXPECT_EQ(options->server, std::nullopt);
  EXPECT_EQ(options->seconds, std::nullopt);
  EXPECT_FALSE(options->demo || options->offscreen);
  EXPECT_EQ(options->level + options->name + options->screenshot, "");
}

TEST(ClientOptions, TheEditorExcludesAMatch) {
  EXPECT_EQ(fault({"--edit", "a.level", "--solid", "icosahedron"}), "none");
  EXPECT_EQ(read({"--edit", "a.level", "--solid", "icosahedron"})->solid, SolidKind::kIcosahedron);
  EXPECT_EQ(read({"--edit", "a.level"})->solid, SolidKind::kHexahedron);
  EXPECT_EQ(fault({"--edit", "a.level", "example.org"}), "2 --edit does not work with HOST; leave one of them out");
  for (const std::vector<const char*>& other :
       {std::vector<const char*>{"--level", "b"}, {"--demo"}, {"--name", "Ann"}, {"--frames", "/tmp"}}) {
    std::vector<const char*> all{"--edit", "a.level"};
    all.insert(all.end(), other.begin(), other.end());
    EXPECT_EQ(fault(all), "2 --edit does not work with " + std::string(other.front()) + "; leave one of them out");
  }
  EXPECT_EQ(fault({"--solid", "ICOSAHEDRON"}), "2 --solid works only with --edit");
  EXPECT_EQ(fault({"--edit", "a.level", "--offscreen"}), "2 --edit with --offscreen needs --screenshot FILE.png");
  EXPECT_EQ(fault({"--edit", ""}), "2 --edit needs the name of a file");
}

TEST(ClientOptions, TheBenchmarkExcludesAMatch) {
  EXPECT_TRUE(read({"--offscreen", "--benchmark", "--json"})->json);
  EXPECT_TRUE(read({"--offscreen", "--benchmark", "--level", "a.level"})->benchmark);
  EXPECT_EQ(fault({"--benchmark"}), "2 --benchmark needs --offscreen");
  EXPECT_EQ(fault({"--offscreen", "--json"}), "2 --json works only with --benchmark");
  for (const std::vector<const char*>& other :
       {std::vector<const char*>{"--demo"}, {"--seconds", "3"}, {"--screenshot", "a.png"}, {"--replay", "a"}}) {
    std::vector<const char*> all{"--offscreen", "--benchmark"};
    all.insert(all.end(), other.begin(), other.end());
    EXPECT_EQ(fault(all), "2 --benchmark does not work with " + std::string(other.front()) + "; leave one of them out");
  }
}

TEST(ClientOptions, PlayingInStepsHasNoWindowAndNoServerElsewhere) {
  EXPECT_TRUE(read({"--offscreen", "--step", "--level", "a.level", "--width", "640"})->step);
  EXPECT_EQ(fault({"--step"}), "2 --step needs --offscreen");
  for (const std::vector<const char*>& other :
       {std::vector<const char*>{"HOST"}, {"--seconds", "3"}, {"--screenshot", "a.png"}, {"--frames", "/tmp"}}) {
    std::vector<const char*> all{"--offscreen", "--step"};
    all.insert(all.end(), other.begin(), other.end());
    EXPECT_EQ(fault(all), "2 --step does not work with " + std::string(other.front()) + "; leave one of them out");
  }
  EXPECT_EQ(fault({"--offscreen", "--step", "--edit", "a"}),
            "2 --edit does not work with --step; leave one of them out");
  EXPECT_EQ(fault({"--offscreen", "--step", "--benchmark"}),
            "2 --benchmark does not work with --step; leave one of them out");
}

TEST(ClientOptions, TheListOfServersExcludesPlaying) {
  EXPECT_TRUE(read({"--list"})->list);
  EXPECT_EQ(fault({"--list", "example.org"}), "2 --list does not work with HOST; leave one of them out");
  EXPECT_EQ(fault({"--list", "--demo"}), "2 --list does not work with --demo; leave one of them out");
}

TEST(ClientOptions, AListOnAWebServerIsForThePrintedListAndTheWindow) {
  EXPECT_EQ(read({"--list-url", "https://example.org/servers.json"})->listUrl, "https://example.org/servers.json");
  EXPECT_TRUE(read({"--list", "--list-url", "http://x"})->list);
  for (const char* const bad : {"example.org", "file:///etc/passwd", "https://", "http://a b", ""}) {
    EXPECT_EQ(
        fault({"--list-url", bad}),
        "2 --list-url must be a URL that begins with https:// or http://, of at most 512 bytes and without spaces");
  }
  for (const std::vector<const char*>& other : std::vector<std::vector<const char*>>{
           {"HOST"}, {"--offscreen"}, {"--demo"}, {"--edit", "a"}, {"--replay", "a"}}) {
    std::vector<const char*> all{"--list-url", "http://x"};
    all.insert(all.end(), other.begin(), other.end());
    EXPECT_EQ(fault(all), "2 --list-url does not work with " + std::string(other.front()) + "; leave one of them out");
  }
}

TEST(ClientOptions, AReplayExcludesAMatchAndTheEditor) {
  EXPECT_EQ(read({"--replay", "a.recording"})->replay, "a.recording");
  EXPECT_EQ(fault({"--replay", "a", "example.org"}), "2 --replay does not work with HOST; leave one of them out");
  EXPECT_EQ(fault({"--replay", "a", "--demo"}), "2 --replay does not work with --demo; leave one of them out");
  EXPECT_EQ(fault({"--edit", "a", "--replay", "b"}), "2 --edit does not work with --replay; leave one of them out");
  EXPECT_EQ(fault({"--replay", "a", "--offscreen"}), "2 --replay with --offscreen needs --screenshot FILE.png");
  EXPECT_EQ(fault({"--replay", ""}), "2 --replay needs the name of a file");
}

TEST(ClientOptions, ReadTheServerAddress) {
  const auto options = read({"example.org:7800", "--name", "Ann", "--seconds", "2.5"});
  ASSERT_TRUE(options && options->server);
  EXPECT_EQ(options->server->text(), "example.org:7800");
  EXPECT_EQ(options->name, "Ann");
  EXPECT_EQ(options->seconds, 2.5);
}

TEST(ClientOptions, ReadALinkToAServer) {
  EXPECT_EQ(read({"platon://example.org:7800/"})->server->text(), "example.org:7800");
}

// It was taken for the name of a server, which nobody could find.
TEST(ClientOptions, AFileInPlaceOfTheServerIsToldFromAServer) {
  const TemporaryFolder folder;
  const std::string file = (folder / "my_room.level").string();
  EXPECT_EQ(fault({"my_room.level"}), "none") << "no such file: it may be a server";
  writeText(file, "");
  EXPECT_EQ(fault({file.c_str()}), "2 '" + file +
                                       "' is a file, but a server is expected here; put --level before a level to "
                                       "play it, --edit to edit it, or --replay before a recording to watch it");
  EXPECT_EQ(fault({"--level", file.c_str()}), "none");
}

TEST(ClientOptions, RefuseALevelForARemoteServer) {
  EXPECT_EQ(fault({"example.org", "--level", "any.level"}),
            "2 --level works only with the embedded server; the server at example.org:7777 chooses its own levels");
}

TEST(ClientOptions, RefuseAnInvalidName) {
  EXPECT_EQ(fault({"--name", "a\tb"}), "2 --name must be at most 32 bytes of UTF-8 without control characters");
}

TEST(ClientOptions, DoNotSimulateNetworkConditions) { EXPECT_EQ(fault({"--loss", "2"}).substr(0, 2), "2 "); }

TEST(ClientOptions, PrintTheHelp) {
  testing::internal::CaptureStdout();
  EXPECT_EQ(read({"--help"}), std::nullopt);
  const std::string help = testing::internal::GetCapturedStdout();
  for (const char* const option : {"HOST", "--level", "--name", "--offscreen", "--demo", "--seconds", "--screenshot"}) {
    EXPECT_NE(help.find(option), std::string::npos) << option;
  }
}

TEST(ServerLinkTest, ALinkHoldsAnAddress) {
  EXPECT_EQ(addressOfLink("platon://play.example.org:7778"), "play.example.org:7778");
  EXPECT_EQ(addressOfLink("platon://play.example.org"), "play.example.org");
  EXPECT_EQ(addressOfLink("platon://[2001:db8::1]:7778"), "[2001:db8::1]:7778");
}

TEST(ServerLinkTest, BrowsersMayAddASlashAndCapitals) {
  EXPECT_EQ(addressOfLink("platon://192.0.2.7/"), "192.0.2.7");
  EXPECT_EQ(addressOfLink("PLATON://192.0.2.7:1"), "192.0.2.7:1");
}

TEST(ServerLinkTest, OtherTextsStayAsTheyAre) {
  for (const char* const text :
       {"play.example.org:7778", "2001:db8::1", "platon", "platon:7778", "platon:/", "", "/"}) {
    EXPECT_EQ(addressOfLink(text), text);
  }
}

TEST(ServerLinkTest, ALinkWithMoreThanAnAddressIsRefused) {
  for (const std::string rest :
       {"", "/", "host/path", "host?name=x", "user@host", "host//", "host:0", "platon://host"}) {
    const std::string link = "platon://" + rest;
    EXPECT_THROW(parseServerAddress(addressOfLink(link)), std::invalid_argument) << link;
  }
}

}  // namespace
}  // namespace platon::client_options_test
