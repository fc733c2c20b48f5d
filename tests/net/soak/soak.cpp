#include "tests/net/soak/soak.h"

#include <algorithm>
#include <sstream>

#include "client/time/steady_now.h"
#include "server/app/level_files.h"
#include "tests/net/attacks/heap_bytes.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

constexpr std::uint8_t kHollowBots = 32;
constexpr std::uint8_t kPlayingBots = 2;
constexpr std::uint8_t kLossyBots = 4;
constexpr double kLoss = 0.05;
constexpr Time kHour = std::chrono::hours(1);
constexpr Time kGathering = seconds(12);  // before a roll call
// A client runs half a tick after the server.
constexpr Time kClientDelay = std::chrono::microseconds(8333);
constexpr Time kTick = std::chrono::microseconds(16667);
constexpr std::size_t kMaxWarnings = 20;

const SocketAddress kServer = addressAt("198.51.100.1", 7777);

// ENet counts 32 bits of milliseconds. They overflow five minutes after the start.
Time startOfTime() {
  constexpr Time kSpan = std::chrono::milliseconds(std::int64_t{1} << 32);
  constexpr Time kBefore = minutes(5);
  return ((steadyClock().now() + kBefore) / kSpan + 1) * kSpan - kBefore;
}

// More than a client remembers.
std::vector<LevelPointer> manyLevels() {
  std::vector<LevelPointer> levels = loadLevelFiles(shippedLevelFiles()).levels;
  for (const LevelPointer& level : {flatLevel(), cornerLevel(), endlessLevel()}) levels.push_back(level);
  for (const std::string& text : {nearGoalText(), farGoalText()}) levels.push_back(levelOf(text));
  return levels;
}

ServerSettings serverSettings() {
  ServerSettings settings;
  settings.match.maxPlayers = 64;
  return settings;
}

// One of them never leaves and changes its buttons in every tick, so that its counters are the first to overflow.
SoakBot::Kind hollowKind(std::uint8_t number) {
  SoakBot::Kind kind;
  kind.isRestless = kind.isPermanent = number == 1;
  if (number > kHollowBots - kLossyBots) kind.loss = kLoss;
  return kind;
}

SoakBot::Kind playingKind(std::uint8_t number) {
  SoakBot::Kind kind;
  kind.isHollow = false;
  kind.isPermanent = number == kHollowBots + 1;
  return kind;
}

}  // namespace

Soak::Soak(const SoakPlan& plan) : plan_(plan), start_(startOfTime()) {
  network_.setFilter([this](const DatagramNetwork::Sent& datagram) { return deliver(datagram); });
  Log log(LogFormat::kJson, [this](std::string_view line) {
    const bool isWarning = line.find("\"warning\"") != line.npos && line.find("traffic rejected") == line.npos;
    if (isWarning) warn(std::string(line));
  });
  server_ = std::make_unique<AttackedServer>(network_, kServer, serverSettings(), manyLevels(), std::move(log));
  for (std::uint8_t number = 1; number <= kHollowBots + kPlayingBots; ++number) {
    const SoakBot::Kind kind = number <= kHollowBots ? hollowKind(number) : playingKind(number);
    bots_.push_back(std::make_unique<SoakBot>(network_, kServer, number, kind));
  }
}

bool Soak::deliver(const DatagramNetwork::Sent& datagram) {
  ++report_.datagrams;
  const SocketAddress& bot = datagram.from == kServer ? datagram.to : datagram.from;
  return bots_[std::size_t{bot.ip.bytes[15]} - 1]->passes(bot);
}

SoakReport Soak::run(const std::function<void(const SoakReport&)>& note) {
  Time nextNote = kHour;
  while (elapsed_ < plan_.length()) {
    step();
    if (elapsed_ < nextNote) continue;
    nextNote += kHour;
    complete();
    note(report_);
  }
  complete();
  return report_;
}

void Soak::step() {
  ++steps_;
  elapsed_ = Time((steps_ * 1'000'000 + kTicksPerSecond - 1) / kTicksPerSecond);
  endRounds();
  server_->tick(start_ + elapsed_);
  countMissedInputs();
  if (isIdle() && elapsed_ + 2 * kTick >= plan_.idleEnd()) callEmpty();
  if (!isIdle() && elapsed_ % plan_.rollCall < kTick && elapsed_ >= plan_.rollCall) callRoll();
  const SoakBot::Order order = orderNow();
  for (const auto& bot : bots_) bot->update(start_ + elapsed_ + kClientDelay, order);
  network_.forgetSent();
}

bool Soak::isIdle() const { return elapsed_ >= plan_.shortRounds && elapsed_ < plan_.idleEnd(); }

SoakBot::Order Soak::orderNow() const {
  if (isIdle()) return SoakBot::Order::kLeave;
  const Time toRollCall = plan_.rollCall - elapsed_ % plan_.rollCall;
  return toRollCall <= kGathering ? SoakBot::Order::kGather : SoakBot::Order::kRoam;
}

// As an operator does who reloads the levels and calls `next`.
void Soak::endRounds() {
  if (elapsed_ >= plan_.shortRounds || elapsed_ < nextRound_) return;
  nextRound_ = elapsed_ + seconds(8) + Time(static_cast<Time::rep>(random_() % 30'000'000));
  const bool reloads = random_() % 16 == 0;
  server_->change([reloads](DedicatedServer& server) {
    if (reloads) server.setLevels(manyLevels());
    server.match().endRoundNow();
  });
}

void Soak::countMissedInputs() {
  const Match& match = server_->server().match();
  const Game& game = match.game();
  report_.longestRound = std::max(report_.longestRound, game.tick());
  report_.rounds = match.round();
  if (std::exchange(lastTick_, game.tick()) == game.tick() || game.tick() == 0) return;
  for (const auto& bot : bots_) {
    if (!bot->isPlaying() || !bot->slot() || *bot->slot() >= game.slots() || bot->kind().loss > 0) continue;
    const std::uint8_t buttons = game.player(*bot->slot()).held;
    report_.missedInputs += bot->misses(match.round(), game.tick() - 1, buttons) ? 1 : 0;
  }
}

void Soak::callRoll() {
  ++report_.rollCalls;
  for (const auto& bot : bots_) report_.absent += bot->isPlaying() ? 0 : 1;
  const std::size_t connected = server_->server().match().players();
  report_.absent += connected < bots_.size() ? bots_.size() - connected : connected - bots_.size();
  const std::int64_t process = heapBytes();
  if (!serverHeap_) {
    serverHeap_ = server_->heapGrowth();
    processHeap_ = process;
  }
  report_.lastGrowth = server_->heapGrowth() - *serverHeap_;
  report_.serverGrowth = std::max(report_.serverGrowth, report_.lastGrowth);
  report_.processGrowth = std::max(report_.processGrowth, process - processHeap_);
}

void Soak::callEmpty() {
  const DedicatedServer& server = server_->server();
  if (!server.match().idle() || !server.host().empty()) warn("the server is not empty");
  report_.idleGrowth = server_->heapGrowth();
}

void Soak::complete() {
  report_.simulated = elapsed_;
  report_.ticks = server_->server().tickTimes().count();
  report_.counts = {};
  report_.desyncs = server_->server().desyncs();
  for (const Rejection& rejection : server_->server().host().rejections().list()) {
    if (rejection.count > 0) report_.rejected[std::string(rejection.reason)] = rejection.count;
  }
  for (const auto& bot : bots_) {
    report_.counts += bot->counts();
    report_.longestTraffic = longer(report_.longestTraffic, bot->longestTraffic());
    report_.desyncs += bot->desyncs();
    report_.corrections += bot->kind().isPermanent ? bot->corrections() : 0;
    for (const std::string& fault : bot->faults()) warn(fault);
  }
}

void Soak::warn(const std::string& text) {
  if (report_.warnings.size() < kMaxWarnings) report_.warnings.push_back(text);
}

std::string SoakReport::text() const {
  std::ostringstream out;
  out << toSeconds(simulated) / 3600 << " h: " << ticks << " ticks, " << rounds << " rounds, the longest of "
      << longestRound << " ticks; " << counts.joins << " joins, " << counts.resumes << " resumes, " << counts.leaves
      << " leaves, " << counts.drops << " lost connections; " << datagrams << " datagrams, "
      << longestTraffic.sentPackets << " up and " << longestTraffic.receivedPackets << " down in one connection; "
      << rollCalls << " roll calls, " << absent << " absent; " << desyncs << " desyncs, " << missedInputs
      << " missed inputs, " << corrections << " corrections; heap of the server " << serverGrowth / 1024
      << " KiB at most, " << lastGrowth / 1024 << " KiB at last, of all " << processGrowth / 1024 << " KiB, idle "
      << idleGrowth / 1024 << " KiB more than at first";
  for (const auto& [reason, count] : rejected) out << "; rejected as " << reason << ": " << count;
  for (const std::string& warning : warnings) out << "\n  " << warning;
  return out.str();
}

}  // namespace platon
