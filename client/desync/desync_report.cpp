#include "client/desync/desync_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "platon/game/state_difference.h"

namespace platon {

namespace {

// Of 256 players there are ten thousand; a server that lies could send states with many times that.
constexpr std::size_t kMaxRows = 20000;

std::string nameOf(const StateDifference& row) { return row.owner + " " + row.field; }

std::string tableOf(const Game& own, const Game& server) {
  std::vector<StateDifference> rows = compareFields(own, server);
  const std::size_t left = rows.size() - std::min(rows.size(), kMaxRows);
  rows.resize(rows.size() - left);
  std::size_t name = 0;
  std::size_t value = 0;
  for (const StateDifference& row : rows) {
    name = std::max(name, nameOf(row).size());
    value = std::max(value, row.left.size());
  }
  std::string text;
  for (const StateDifference& row : rows) {
    text += fmt::format("{} {:<{}}  {:<{}}  {}\n", row.differs() ? '!' : ' ', nameOf(row), name, row.left, value,
                        row.right);
  }
  if (left > 0) text += fmt::format("and {} more\n", left);
  return text;
}

std::string differenceOf(const Desync& desync) {
  if (!desync.server) return "the server's state has not come, so that no field can be named";
  const auto difference = firstDifference(desync.own, *desync.server);
  const std::uint32_t own = desync.own.tick();
  const std::uint32_t server = desync.server->tick();
  const std::string at =
      own == server ? fmt::format("after tick {}", own) : fmt::format("after ticks {} here and {} there", own, server);
  if (!difference) return at + " no field differs any more";
  return fmt::format("{} the first field that differs is {} of {}: {} here, {} on the server", at, difference->field,
                     difference->owner, difference->left, difference->right);
}

std::string remarkOf(const Desync& desync) {
  const std::uint32_t own = desync.own.tick();
  if (desync.guessedTicks > 0) {
    return fmt::format(
        "the inputs of the {} ticks from {} on never came here; all players were taken to do what they "
        "did in tick {}, so that a field may also differ for that",
        desync.guessedTicks, own - 1 - desync.guessedTicks, own - 1);
  }
  if (desync.server && own != desync.server->tick()) {
    return "there was no own state of the server's tick, so that fields may also differ for that";
  }
  return "";
}

std::string hashLine(const char* whose, const Game& game) {
  return fmt::format("{:<24}after tick {}, hash {:016x}\n", whose, game.tick(), game.hash());
}

std::string headOf(const Desync& desync) {
  const Level& level = desync.own.level();
  std::string text = fmt::format("{:<24}{}\n{:<24}{:016x}\n{:<24}{}\n{:<24}{}\n", "level", level.title, "level hash",
                                 level.hash, "round", desync.round, "rules version", kRulesVersion);
  text += fmt::format("{:<24}after tick {}\n", "last known to agree", desync.agreedAt);
  text += fmt::format("{:<24}after tick {}, hash …{:08x} here, …{:08x} on the server\n", "first known to differ",
                      desync.tick, desync.ownHash, desync.serverHash);
  text += hashLine("own state", desync.own);
  text += desync.server ? hashLine("the server's state", *desync.server) : "";
  return text;
}

}  // namespace

DesyncReport reportOf(Desync desync) {
  DesyncReport report;
  const std::string difference = differenceOf(desync);
  report.summary = fmt::format("round {}: the game was not the server's after tick {}, and was after tick {}; {}",
                               desync.round, desync.tick, desync.agreedAt, difference);
  report.text = headOf(desync) + difference + "\n";
  const std::string remark = remarkOf(desync);
  if (!remark.empty()) report.text += remark + "\n";
  if (desync.server) report.text += "\nField, here, on the server:\n" + tableOf(desync.own, *desync.server);
  report.recording = std::move(desync.recording);
  return report;
}

}  // namespace platon
