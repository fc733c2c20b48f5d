#include "client/desync/desync_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <system_error>
#include <utility>

#include "platon/game/state_difference.h"

namespace platon {

namespace {

// 256 players have about 10 000 fields; a malicious server could send states with many more.
constexpr std::size_t kMaxRows = 20000;

std::string nameOf(const StateDifference& row) { return row.owner + " " + row.field; }

std::string tableOf(const Game& client, const Game& server) {
  std::vector<StateDifference> rows = compareFields(client, server);
  const std::size_t omitted = rows.size() - std::min(rows.size(), kMaxRows);
  rows.resize(rows.size() - omitted);
  std::size_t nameWidth = 0;
  std::size_t valueWidth = 0;
  for (const StateDifference& row : rows) {
    nameWidth = std::max(nameWidth, nameOf(row).size());
    valueWidth = std::max(valueWidth, row.left.size());
  }
  std::string text;
  for (const StateDifference& row : rows) {
    text += fmt::format("{} {:<{}}  {:<{}}  {}\n", row.differs() ? '!' : ' ', nameOf(row), nameWidth, row.left,
                        valueWidth, row.right);
  }
  if (omitted > 0) text += fmt::format("{} more fields omitted\n", omitted);
  return text;
}

std::string differenceOf(const Desync& desync) {
  if (!desync.server) return "the server's state did not arrive";
  const std::uint32_t client = desync.client.tick();
  const std::uint32_t server = desync.server->tick();
  if (client != server) return fmt::format("client state at tick {}, server state at tick {}", client, server);
  const auto difference = firstDifference(desync.client, *desync.server);
  if (!difference) return fmt::format("no difference at tick {}", client);
  return fmt::format("first difference at tick {}: {} of {} is {} on the client, {} on the server", client,
                     difference->field, difference->owner, difference->left, difference->right);
}

std::string stateLine(const char* label, const Game& game) {
  return fmt::format("{:<24}tick {}, hash {:016x}\n", label, game.tick(), game.hash());
}

std::string headOf(const Desync& desync) {
  const Level& level = desync.client.level();
  std::string text = fmt::format("{:<24}{}\n{:<24}{:016x}\n{:<24}{}\n{:<24}{}\n", "level", level.title, "level hash",
                                 level.hash, "round", desync.round, "rules version", kRulesVersion);
  text += fmt::format("{:<24}tick {}\n", "last match", desync.matchedAt);
  text += fmt::format("{:<24}tick {}, short hash {:08x} on the client, {:08x} on the server\n", "desync", desync.tick,
                      desync.clientHash, desync.serverHash);
  text += stateLine("client state", desync.client);
  text += desync.server ? stateLine("server state", *desync.server) : "";
  return text;
}

}  // namespace

DesyncReport reportOf(Desync desync) {
  DesyncReport report;
  const std::string difference = differenceOf(desync);
  report.summary = fmt::format("round {}: desync at tick {}, last match at tick {}; {}", desync.round, desync.tick,
                               desync.matchedAt, difference);
  report.text = headOf(desync) + difference + "\n";
  if (desync.server) report.text += "\nField, client, server:\n" + tableOf(desync.client, *desync.server);
  report.recording = std::move(desync.recording);
  return report;
}

void DesyncReports::add(std::optional<Desync> desync, Time now) {
  if (!desync || (reportedAt_ && now - *reportedAt_ < kInterval)) return;
  reportedAt_ = now;
  last_ = reportOf(std::move(*desync));
}

namespace {

// Creates a file with its whole content or not at all; never overwrites one. Returns 0 or the error number.
template <class Bytes>
int createFile(const std::filesystem::path& path, const Bytes& bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) return errno;
  int error = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  std::error_code ignored;
  if (error != 0) std::filesystem::remove(path, ignored);
  return error;
}

std::string failure(const std::filesystem::path& path, int error) {
  return "; cannot write " + path.string() + ": " + std::strerror(error);
}

}  // namespace

std::string DesyncFolder::write(const DesyncReport& report) const {
  if (folder_.empty()) return report.summary;
  std::error_code ignored;  // createFile reports the error
  std::filesystem::create_directories(folder_, ignored);
  for (int number = 1; number <= kMaxReports; ++number) {
    const std::string name = "desync-" + std::to_string(number);
    const std::filesystem::path text = folder_ / (name + ".txt");
    const std::filesystem::path recording = folder_ / (name + ".recording");
    // Both files must be new. The recording is created first, so that no text names the recording of another report.
    if (std::filesystem::exists(text, ignored)) continue;
    const int error = createFile(recording, report.recording);
    if (error == EEXIST) continue;
    if (error != 0) return report.summary + failure(recording, error);
    const int textError =
        createFile(text, report.text + "\nRecording of the client's game: " + recording.string() + "\n");
    return report.summary + (textError == 0 ? "; see " + text.string() : failure(text, textError));
  }
  return report.summary + "; not written: " + folder_.string() + " already has " + std::to_string(kMaxReports) +
         " reports; remove those you do not need";
}

}  // namespace platon
