#include "client/mismatch_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "shared/game/state_difference.h"

namespace platon {

namespace {

// Of 256 players there are ten thousand; a server that lies could send states with many times that.
constexpr std::size_t kMostRows = 20000;

std::string nameOf(const StateDifference& row) { return row.owner + " " + row.field; }

std::string tableOf(const Game& own, const Game& server) {
  std::vector<StateDifference> rows = sideBySide(own, server);
  const std::size_t left = rows.size() - std::min(rows.size(), kMostRows);
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

std::string differenceOf(const Mismatch& mismatch) {
  if (!mismatch.server) return "the server's state has not come, so that no field can be named";
  const auto difference = firstDifference(mismatch.own, *mismatch.server);
  const std::uint32_t own = mismatch.own.tick();
  const std::uint32_t server = mismatch.server->tick();
  const std::string at = own == server ? fmt::format("after tick {}", own)
                                       : fmt::format("after ticks {} here and {} there", own, server);
  if (!difference) return at + " no field differs any more";
  return fmt::format("{} the first field that differs is {} of {}: {} here, {} on the server", at, difference->field,
                     difference->owner, difference->left, difference->right);
}

std::string remarkOf(const Mismatch& mismatch) {
  const std::uint32_t own = mismatch.own.tick();
  if (mismatch.guessedTicks > 0) {
    return fmt::format("the inputs of the {} ticks from {} on never came here; all players were taken to do what they "
                       "did in tick {}, so that a field may also differ for that",
                       mismatch.guessedTicks, own - 1 - mismatch.guessedTicks, own - 1);
  }
  if (mismatch.server && own != mismatch.server->tick()) {
    return "there was no own state of the server's tick, so that fields may also differ for that";
  }
  return "";
}

std::string hashLine(const char* whose, const Game& game) {
  return fmt::format("{:<24}after tick {}, hash {:016x}\n", whose, game.tick(), game.hash());
}

std::string headOf(const Mismatch& mismatch) {
  const Level& level = mismatch.own.level();
  std::string text = fmt::format("{:<24}{}\n{:<24}{:016x}\n{:<24}{}\n{:<24}{}\n", "level", level.title, "level hash",
                                 level.hash, "round", mismatch.round, "rules version", kRulesVersion);
  text += fmt::format("{:<24}after tick {}\n", "last known to agree", mismatch.agreedAt);
  text += fmt::format("{:<24}after tick {}, hash …{:08x} here, …{:08x} on the server\n", "first known to differ",
                      mismatch.tick, mismatch.ownHash, mismatch.serverHash);
  text += hashLine("own state", mismatch.own);
  text += mismatch.server ? hashLine("the server's state", *mismatch.server) : "";
  return text;
}

}  // namespace

MismatchReport reportOf(Mismatch mismatch) {
  MismatchReport report;
  const std::string difference = differenceOf(mismatch);
  report.summary = fmt::format("round {}: the game was not the server's after tick {}, and was after tick {}; {}",
                               mismatch.round, mismatch.tick, mismatch.agreedAt, difference);
  report.text = headOf(mismatch) + difference + "\n";
  const std::string remark = remarkOf(mismatch);
  if (!remark.empty()) report.text += remark + "\n";
  if (mismatch.server) report.text += "\nField, here, on the server:\n" + tableOf(mismatch.own, *mismatch.server);
  report.recording = std::move(mismatch.recording);
  return report;
}

}  // namespace platon
