#include <gtest/gtest.h>
#include <ifaddrs.h>
#include <signal.h>

#include <chrono>
#include <cstring>
#include <filesystem>

#include "protocol/transport/socket_address.h"
#include "server/program/options.h"
#include "tests/net/support/enet_client.h"
#include "tests/net/support/served_metrics.h"
#include "tests/support/environment_variable.h"
#include "tests/support/files.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_levels.h"
#include "tests/support/wait_until.h"

namespace platon::server_program_test {
namespace {

/// A level file for one test.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() { write(farGoalText()); }

  void write(const std::string& text) const { writeText(level_, text); }
  static std::string lastLine(Process& server) {
    std::string last;
    for (std::string next = server.nextErrorLine(); !next.empty(); next = server.nextErrorLine()) last = next;
    return last;
  }
  static std::uint16_t portOf(const std::string& line) {
    return static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1)));
  }

  static void ends(const std::vector<std::string>& arguments, int code, const std::string& start) {
    Process server(platonCommand("platon-server", arguments));
    const std::string first = server.nextErrorLine();
    EXPECT_TRUE(first.starts_with(start)) << first;
    EXPECT_EQ(server.wait(), code) << first;
  }

  const TemporaryFolder folder_ = TemporaryFolder::forSockets();
  const std::string level_ = folder_ / "test.level";
};

TEST_F(ProgramTest, ListensAndTellsTheClientsWhenStopped) {
  for (const int number : {SIGTERM, SIGINT}) {
    Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
    const std::string line = server.nextErrorLine();
    ASSERT_TRUE(line.starts_with("listening on 127.0.0.1:")) << line;
    EnetClient ann(portOf(line), FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
    const auto step = [&ann] { ann.step(); };
    EXPECT_TRUE(stepUntil(step, [&ann] { return ann.fake().confirmed() >= 10; }));
    server.signal(number);
    EXPECT_TRUE(stepUntil(step, [&ann] { return ann.fake().bye().has_value(); }));
    EXPECT_EQ(server.wait(), 0);
    EXPECT_TRUE(lastLine(server).starts_with("tick times ticks="));
  }
}

TEST_F(ProgramTest, ReloadsLevelsOnHangUp) {
  Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
  server.nextErrorLine();
  server.waitForError("round started title=\"\"");
  write("CUBE\n");
  server.signal(SIGHUP);
  server.waitForError(level_ + ":1:1: error: ");
  server.waitForError("configuration and levels not reloaded");
  write(nearGoalText());
  server.signal(SIGHUP);
  server.waitForError("configuration and levels reloaded");
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(ProgramTest, ReloadsALevelWhoseFileHasChanged) {
  Process server(platonCommand("platon-server", {level_, "--port", "0", "--bind", "127.0.0.1"}));
  server.waitForError("round started title=\"\"");
  write("CUBE\n");
  server.waitForError(level_ + ":1:1: error: ");
  server.waitForError("levels not reloaded");
  write(nearGoalText());
  server.waitForError("levels reloaded");
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(ProgramTest, KeepsItsSettingsWhenTheNewOnesAreInvalid) {
  const std::string file = folder_ / "server.toml";
  writeText(file, "levels = [\"test.level\"]\nlog-format = \"json\"\n");
  Process server(platonCommand("platon-server", {"--config", file, "--port", "0", "--bind", "127.0.0.1"}));
  std::string line = server.nextErrorLine();
  while (!line.empty() && line.find(R"("message":"round started")") == std::string::npos) line = server.nextErrorLine();
  EXPECT_EQ(line.find("level"), line.rfind("level")) << "a key that stands twice hides the severity: " << line;
  std::string deepTable = "[a";
  for (int i = 0; i < 100'000; ++i) deepTable += ".a";
  for (const std::string& text :
       {std::string("log-format = \"text\"\nmax-players = 0\n"),
        std::string("log-format = \"text\"\nlevels = [\"none.level\"]\n"),
        std::string("log-format = \"text\"\ncolour = 1\n"), std::string("log-format ="), deepTable + "]\n"}) {
    writeText(file, text);
    server.signal(SIGHUP);
    const std::string error = server.nextErrorLine();
    EXPECT_TRUE(error.starts_with("{")) << "the log is still JSON: " << error;
    EXPECT_NE(server.nextErrorLine().find("configuration and levels not reloaded"), std::string::npos) << error;
  }
  writeText(file, "levels = [\"test.level\"]\nlog-format = \"text\"\n");
  server.signal(SIGHUP);
  EXPECT_EQ(server.nextErrorLine(), "configuration and levels reloaded");
  server.signal(SIGTERM);
  EXPECT_EQ(server.wait(), 0);
}

TEST_F(ProgramTest, ExitCodesAreThoseOfTheManual) {
  ends({"--colour"}, 2, "platon-server: The following argument was not expected: --colour");
  ends({level_, "--port", "0", "--record", level_ + "/games"}, 2,
       "platon-server: cannot write recordings to '" + level_ +
           "/games': the folder cannot be created: Not a directory; name another folder");
  ends({"/no/such.level"}, 2, "platon-server: cannot read the level '/no/such.level'");
  ends({level_, "--metrics", "19777"}, 2, "platon-server: --metrics must be an address and a port, such as ");
  ends({level_, "--port", "0", "--ban-file", "/no/such/bans"}, 2,
       "platon-server: /no/such/bans: error: No such file or directory; name a readable ban file");
  ends({level_, "--port", "0", "--socket", level_}, 2,
       "platon-server: cannot open the console at '" + level_ + "': it is not a socket; name another path");
  write("CUBE\n");
  ends({level_}, 3, level_ + ":1:1: error: ");
}

/// A server with a console, a ban file and metrics.
class ToolsTest : public ProgramTest {
 protected:
  ToolsTest() { writeText(bans_, "# mine\n"); }

  void start(std::vector<std::string> arguments = {"--bind", "127.0.0.1"}) {
    arguments.insert(arguments.end(),
                     {level_, "--port", "0", "--socket", socket_, "--ban-file", bans_, "--metrics", "127.0.0.1:0"});
    server_.emplace(platonCommand("platon-server", arguments));
    port_ = portOf(server_->nextErrorLine());
  }

  // Runs the console with these lines.
  ProcessResult console(const std::string& lines) const {
    writeText(folder_ / "commands", lines);
    ProcessOptions options;
    options.inputFile = folder_ / "commands";
    return runProcess(platonCommand("platon-server", {"--console", "--socket", socket_}), options);
  }

  static std::chrono::sys_seconds now() {
    return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
  }

  const std::string socket_ = folder_ / "console.sock";
  const std::string bans_ = folder_ / "bans.txt";
  std::optional<Process> server_;
  std::uint16_t port_ = 0;
};

// With 2, systemd does not start it again: node_exporter had the port of the metrics, and the server stayed down.
TEST_F(ToolsTest, AnAddressInUseExitsWith1SoThatSystemdTriesAgain) {
  start();
  const std::string page = server_->waitForError("metrics on ");
  const std::string game = "127.0.0.1:" + std::to_string(port_);
  const std::vector<std::string> common{level_, "--bind", "127.0.0.1"};
  const auto with = [&common](std::vector<std::string> options) {
    options.insert(options.end(), common.begin(), common.end());
    return options;
  };
  const std::string remedy = ": Address already in use; stop the program that uses it or choose another port after --";
  ends(with({"--port", std::to_string(port_)}), 1, "platon-server: cannot listen on " + game + remedy + "port");
  ends(with({"--port", "0", "--metrics", page}), 1,
       "platon-server: cannot serve metrics on " + page + remedy + "metrics");
  ends(with({"--port", "0", "--socket", socket_}), 1,
       "platon-server: cannot open the console at '" + socket_ +
           "': another server uses it; name another path after --socket");
}

TEST_F(ToolsTest, TheConsoleControlsTheServer) {
  start();
  server_->waitForError("console on " + socket_);
  EnetClient ann(port_, FakeClient("Ann", 8, [](std::uint32_t) { return 0; }));
  const auto step = [&ann] { ann.step(); };
  ASSERT_TRUE(stepUntil(step, [&ann] { return ann.fake().confirmed() >= 10; }));
  const ProcessResult players = console("players\nkick 1 too loud\n");
  EXPECT_EQ(players.exitCode, 0);
  EXPECT_TRUE(players.output.starts_with("1  this machine  \"Ann\"")) << players.output;
  EXPECT_TRUE(players.output.ends_with("\nremoved player 1 (Ann)\n")) << players.output;
  server_->waitForError("console command=\"kick 1 too loud\"");
  ASSERT_TRUE(stepUntil(step, [&ann] { return ann.disconnected(); }));
  EXPECT_EQ(ann.fake().bye()->reason, "you were removed by the operator of the server: too loud");
}

TEST_F(ToolsTest, AFailedCommandGivesExitCode1) {
  start();
  const ProcessResult result = console("kick 9\nstatus\n");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_EQ(result.errors, "error: there is no player '9': the command 'players' lists all of them\n");
  EXPECT_TRUE(result.output.starts_with("server: Platon\naddress: 127.0.0.1:" + std::to_string(port_) + "\n"));
}

TEST_F(ToolsTest, TheConsoleStopsTheServer) {
  start();
  EXPECT_EQ(console("stop\n").output, "the server stops\n");
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_FALSE(std::filesystem::exists(socket_));
  const ProcessResult result = console("status\n");
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_TRUE(result.errors.starts_with("platon-server: no server answers at '" + socket_ + "'")) << result.errors;
}

TEST_F(ToolsTest, TheConsoleDrainsTheServer) {
  start();
  EXPECT_EQ(console("drain\n").errors, "error: name the longest time in seconds, as in 'drain 600'\n");
  EXPECT_EQ(console("drain 5 127.0.0.1:7777\n").output, "the server stops after this round, at the latest in 5 s\n");
  server_->waitForError("draining seconds=5 next=\"127.0.0.1:7777\"");
  EXPECT_EQ(server_->wait(), 0);
}

TEST_F(ToolsTest, TheConsoleReloads) {
  start();
  write("CUBE\n");
  const ProcessResult broken = console("reload\n");
  EXPECT_EQ(broken.exitCode, 1);
  EXPECT_TRUE(broken.errors.starts_with("error: " + level_ + ":1:1: error: ")) << broken.errors;
  EXPECT_TRUE(broken.errors.ends_with("\nconfiguration and levels not reloaded\n")) << broken.errors;
  write(nearGoalText());
  EXPECT_EQ(console("reload\n").output, "configuration and levels reloaded\n");
}

TEST_F(ToolsTest, AReloadReadsTheBansAgainAndKeepsThemOnAnError) {
  start();
  writeText(bans_, "192.0.2.7\n");
  EXPECT_EQ(console("reload\nbans\n").output, "configuration and levels reloaded\n192.0.2.7\n");
  writeText(bans_, "192.0.2.8\nAnn\n");
  EXPECT_TRUE(console("reload\n").errors.starts_with("error: " + bans_ + ":2:1: error: "));
  EXPECT_EQ(console("bans\n").output, "192.0.2.7\n");
}

TEST_F(ToolsTest, AReloadNamesWhatWaitsForARestart) {
  const std::string config = folder_ / "server.toml";
  writeText(config, "name = \"One\"\n");
  start({"--bind", "127.0.0.1", "--config", config});
  writeText(config, "name = \"Two\"\nmax-players = 5\nrecord = \"games\"\n");
  EXPECT_EQ(console("reload\n").output,
            "configuration and levels reloaded; restart the server to change max-players, record\n");
  EXPECT_TRUE(console("status\n").output.starts_with("server: Two\n"));
}

TEST_F(ToolsTest, ABanIsWrittenToTheFile) {
  start();
  EXPECT_EQ(console("ban 192.0.2.0/24 too loud\n").exitCode, 0);
  EXPECT_TRUE(waitUntil([this] { return readText(bans_) == "# mine\n192.0.2.0/24 too loud\n"; }));
}

// `folder` with folders below until the path of a file in them is as long as the system takes.
std::filesystem::path deepest(std::filesystem::path folder) {
  constexpr std::size_t kMaxBytes = 4095;
  constexpr std::size_t kNameBytes = 200;
  while (folder.native().size() + 1 + kNameBytes + 40 < kMaxBytes) folder /= std::string(kNameBytes, 'b');
  std::filesystem::create_directories(folder);
  return folder / std::string(kMaxBytes - folder.native().size() - 1, 'b');
}

// A file with a longer path cannot be made beside this one, so the server can only read it.
class UnwrittenBanTest : public ToolsTest {
 protected:
  UnwrittenBanTest() {
    writeText(file_, "");
    std::filesystem::remove(bans_);
    std::filesystem::create_symlink(file_, bans_);
    start();
    EXPECT_EQ(console("ban 192.0.2.7\n").exitCode, 0);
    server_->waitForError(notWritten_);
  }

  const std::string file_ = deepest(folder_.path());
  const std::string notWritten_ = "bans not written file=\"" + bans_ +
                                  "\" reason=\"File name too long; make room on the disk, and let the server write to "
                                  "the folder of the file\"\n";
};

TEST_F(UnwrittenBanTest, ItsWriteIsTriedOnceMoreAtTheStop) {
  std::filesystem::remove(bans_);
  writeText(bans_, "");
  EXPECT_EQ(console("stop\n").exitCode, 0);
  EXPECT_EQ(server_->wait(), 0);
  EXPECT_TRUE(server_->errors().ends_with("\nbans written file=\"" + bans_ + "\"\n")) << server_->errors();
  EXPECT_EQ(readText(bans_), "192.0.2.7\n");
}

// It exited with 0, as if nothing were lost.
TEST_F(UnwrittenBanTest, BansThatAreLostAtTheStopExitWith1) {
  for (const bool bySignal : {true, false}) {
    if (bySignal) server_->signal(SIGTERM);
    if (!bySignal) {
      start();
      EXPECT_EQ(console("ban 192.0.2.7\nstop\n").exitCode, 0);
    }
    EXPECT_EQ(server_->wait(), 1);
    EXPECT_TRUE(server_->errors().ends_with("\nbans lost file=\"" + bans_ +
                                            "\" reason=\"File name too long; make room on the disk, let the server "
                                            "write to the folder of the file, and add what is missing from it\"\n"))
        << server_->errors();
  }
}

TEST_F(UnwrittenBanTest, TheMetricsCountIt) {
  const std::string answer = servedMetrics(*server_);
  EXPECT_NE(answer.find("\nplaton_unwritten_bans_total "), std::string::npos) << answer;
  EXPECT_EQ(answer.find("\nplaton_unwritten_bans_total 0\n"), std::string::npos) << answer;
  EXPECT_NE(answer.find("\nplaton_unwritten_best_times_total 0\n"), std::string::npos) << answer;
}

TEST_F(UnwrittenBanTest, TheEndOfAFailureIsLogged) {
  std::filesystem::remove(bans_);
  writeText(bans_, "");
  EXPECT_EQ(console("ban 192.0.2.8\n").exitCode, 0);  // the file is written at once
  server_->waitForError("bans written file=\"" + bans_ + "\"\n");
  EXPECT_EQ(readText(bans_), "192.0.2.7\n192.0.2.8\n");
}

TEST_F(UnwrittenBanTest, AReloadIsRefused) {
  writeText(file_, "192.0.2.8\n");
  const ProcessResult reload = console("reload\n");
  EXPECT_EQ(reload.exitCode, 1);
  EXPECT_TRUE(
      reload.errors.starts_with("error: " + bans_ + ": error: the last change of the bans has not been written"))
      << reload.errors;
  EXPECT_EQ(console("bans\n").output, "192.0.2.7\n");
}

// An address of this machine that is not loopback, which cannot be banned; nothing if it has none.
std::optional<IpAddress> publicAddress() {
  ifaddrs* all = nullptr;
  std::optional<IpAddress> found;
  if (getifaddrs(&all) != 0) return found;
  for (const ifaddrs* one = all; one; one = one->ifa_next) {
    if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
    SystemAddress system{};
    std::memcpy(&system, one->ifa_addr, sizeof system.ipv4);
    const IpAddress address = fromSystem(system).ip;
    if (address.ipv4()[0] != 127) found = address;
  }
  freeifaddrs(all);
  return found;
}

TEST_F(ToolsTest, ABannedAddressCannotJoin) {
  const auto address = publicAddress();
  if (!address) GTEST_SKIP() << "this machine has no address but loopback";
  start();
  server_.reset();
  start({"--bind", address->text()});
  EXPECT_EQ(console("ban " + address->text() + " too loud\n").exitCode, 0);
  const ProcessResult bot = runProcess(
      platonCommand("platon-bot", {address->text() + ":" + std::to_string(port_), "--count", "1", "--seconds", "5"}));
  EXPECT_EQ(bot.exitCode, 1);
  EXPECT_NE(bot.errors.find("you are banned from this server: too loud"), std::string::npos) << bot.errors;
}

TEST_F(ToolsTest, TheMetricsAreServed) {
  const std::chrono::sys_seconds before = now();
  start();
  const std::string answer = servedMetrics(*server_);
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\nContent-Type: text/plain; version=0.0.4\r\n"));
  EXPECT_NE(answer.find("\nplaton_players{state=\"connected\"} 0\n"), std::string::npos) << answer;
  EXPECT_NE(answer.find("\nplaton_players_limit 16\n"), std::string::npos) << answer;
  EXPECT_NE(answer.find(",name=\"Platon\"} 1\n"), std::string::npos) << answer;
  const std::string start = "\nprocess_start_time_seconds ";
  ASSERT_NE(answer.find(start), std::string::npos) << answer;
  const std::chrono::seconds started(std::stoll(answer.substr(answer.find(start) + start.size())));
  EXPECT_GE(started, before.time_since_epoch());
  EXPECT_LE(started, now().time_since_epoch());
}

TEST_F(ToolsTest, TheSecondServerOfADefaultPathRunsWithoutAConsole) {
  const EnvironmentVariable runtime("XDG_RUNTIME_DIR", folder_.path().string());
  const std::vector<std::string> arguments{level_, "--bind", "127.0.0.1", "--port", "0"};
  Process first(platonCommand("platon-server", arguments));
  const std::string path = folder_ / "platon-server.sock";
  first.waitForError("console on " + path);
  Process second(platonCommand("platon-server", arguments));
  second.waitForError("listening on ");
  second.waitForError("no console: cannot open the console at '" + path +
                      "': another server uses it; name another path after --socket");
  second.signal(SIGTERM);
  EXPECT_EQ(second.wait(), 0);
  ProcessOptions nothingToDo;
  nothingToDo.inputFile = "/dev/null";
  EXPECT_EQ(runProcess(platonCommand("platon-server", {"--console"}), nothingToDo).exitCode, 0);
  Process third(platonCommand("platon-server", {level_, "--bind", "127.0.0.1", "--port", "0", "--socket", path}));
  EXPECT_EQ(third.wait(), 1);
}

TEST_F(ToolsTest, AKilledServerLeavesNoObstacle) {
  start();
  server_->signal(SIGKILL);
  server_->wait();
  EXPECT_TRUE(std::filesystem::exists(socket_));
  start();
  EXPECT_EQ(console("status\n").exitCode, 0);
}

TEST_F(ProgramTest, PrintsAConfigurationThatItAccepts) {
  const ProcessResult printed = runProcess(platonCommand("platon-server", {"--print-config"}));
  EXPECT_EQ(printed.exitCode, 0);
  EXPECT_EQ(printed.output, printedConfig());
  const std::string file = folder_ / "server.toml";
  writeText(file, printed.output);
  const ProcessResult checked = runProcess(platonCommand("platon-server", {"--check-config", "--config", file}));
  EXPECT_EQ(checked.exitCode, 0) << checked.errors;
  EXPECT_TRUE(checked.output.starts_with("levels: ")) << checked.output;
}

TEST_F(ProgramTest, CheckingAConfigurationPrintsEveryError) {
  write("CUBE\n");
  const std::string file = folder_ / "server.toml";
  writeText(file, "port = 70000\ncolour = 1\n");
  const auto check = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"--check-config"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return runProcess(platonCommand("platon-server", all));
  };
  const ProcessResult both = check({"--config", file, level_});
  EXPECT_EQ(both.exitCode, 2);
  for (const std::string& start : {file + ":1:8: error: ", file + ":2:1: error: ", level_ + ":1:1: error: "}) {
    EXPECT_NE(("\n" + both.errors).find("\n" + start), std::string::npos) << both.errors;
  }
  EXPECT_EQ(check({level_}).exitCode, 3);
}

}  // namespace
}  // namespace platon::server_program_test
