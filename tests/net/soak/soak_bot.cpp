#include "tests/net/soak/soak_bot.h"

#include <algorithm>
#include <cstring>

namespace platon {
namespace {

using std::chrono::seconds;

// For joining, also with loss.
constexpr Time kJoinTime = seconds(8);
// For leaving, as our programs wait for it. With loss it may not suffice; the server then notices the silence.
constexpr Time kFarewellTime = std::chrono::milliseconds(500);
// The server keeps a disconnected player for at least this long.
constexpr Time kResumable = seconds(60);
constexpr std::uint16_t kFirstPort = 5000;
constexpr std::uint16_t kPorts = 8;

SessionToken tokenOf(std::uint8_t number, std::uint64_t player) {
  SessionToken token{number};
  std::memcpy(token.data() + 1, &player, sizeof player);
  return token;
}

SocketAddress addressOf(std::uint8_t number, std::uint16_t connection) {
  return addressAt("10.0.0." + std::to_string(number), static_cast<std::uint16_t>(kFirstPort + connection % kPorts));
}

}  // namespace

SoakBot::SoakBot(DatagramNetwork& network, const SocketAddress& server, std::uint8_t number, const Kind& kind)
    : network_(network),
      server_(server),
      number_(number),
      kind_(kind),
      name_("bot " + std::to_string(number)),
      random_(number) {
  memory_.token = tokenOf(number_, 0);
}

Time SoakBot::between(int lowSeconds, int highSeconds) {
  const auto span = static_cast<std::uint64_t>(highSeconds - lowSeconds) * 1'000'000;
  return seconds(lowSeconds) + Time(static_cast<Time::rep>(random_() % span));
}

bool SoakBot::passes(const SocketAddress& own) {
  if (!connection_ || own.port != addressOf(number_, connections_).port) return false;
  return kind_.loss == 0 || static_cast<double>(random_() % 10'000) >= kind_.loss * 10'000;
}

void SoakBot::update(Time now, Order order) {
  if (!connection_) {
    if (order == Order::kGather || (order == Order::kRoam && now >= nextMove_)) connect(now);
    return;
  }
  const bool departs = order == Order::kLeave || (order == Order::kRoam && !kind_.isPermanent && now >= nextMove_);
  if (departs && isPlaying()) depart(now, order == Order::kLeave);
  if (connection_) exchange(now);
}

void SoakBot::connect(Time now) {
  ++connections_;
  if (slot_ && now >= resumableUntil_) forget();
  connection_.emplace(network_.socket(addressOf(number_, connections_)), std::vector{server_}, ServerKnowledge{});
  since_ = now;
}

void SoakBot::exchange(Time now) {
  connection_->service(now, [&](std::span<const std::uint8_t> message) {
    if (client_) client_->receive(message, now);
  });
  if (!client_ && connection_->state() == EnetLink::State::kConnected) startSession(now);
  if (client_) {
    if (!leaving_) client_->update(now);
    for (const OutgoingMessage& message : client_->takeOutgoing()) send(message);
    if (leaving_) connection_->close();
    connection_->flush(now);
  }
  checkSession(now);
}

void SoakBot::send(const OutgoingMessage& message) {
  connection_->send(message.bytes, message.reliable);
  const auto decoded = decodeToServer(message.bytes);
  if (decoded && std::holds_alternative<PlayerInputs>(*decoded)) inputs_.sent(std::get<PlayerInputs>(*decoded));
}

void SoakBot::startSession(Time now) {
  const std::uint64_t seed = random_();
  inputs_ = InputCheck();
  client_ = kind_.isHollow ? makeHollowClient(name_, memory_, seed, kind_.isRestless, now)
                           : makePlayingClient(name_, memory_, seed, now);
  nextMove_ = now + between(5, 90);
}

void SoakBot::noteJoined() {
  if (hasJoined_ || !isPlaying()) return;
  hasJoined_ = true;
  const std::uint32_t slot = client_->welcome()->slot;
  if (slot_ && *slot_ != slot) fault("it did not resume its player");
  ++(slot_ ? counts_.resumes : counts_.joins);
  slot_ = slot;
}

void SoakBot::checkSession(Time now) {
  const bool isClosed = connection_->state() == EnetLink::State::kClosed;
  const bool isLate = now - since_ > (leaving_ ? kFarewellTime : kJoinTime);
  if (leaving_) {
    if (isLate && kind_.loss == 0) fault("it could not leave in time");
    if (isLate || isClosed) leave(now);
    return;
  }
  const std::optional<std::string> ending = client_ ? client_->ending() : std::nullopt;
  if (ending) fault("its session ended: " + *ending);
  if (isClosed) fault("its connection was closed");
  if (isLate && !hasJoined_) fault("it could not join in time");
  if (ending || isClosed || (isLate && !hasJoined_)) return drop(now);
  noteJoined();
}

void SoakBot::depart(Time now, bool politely) {
  if (politely || random_() % 2 == 0) {
    ++counts_.leaves;
    leaving_ = true;
    since_ = now;
    client_->leave();
    return;
  }
  ++counts_.drops;
  drop(now);
  resumableUntil_ = now + kResumable;
  const bool resumes = random_() % 4 != 0;
  nextMove_ = now + (resumes ? between(0, 50) : between(61, 100));
}

// The connection ends without a word.
void SoakBot::drop(Time now) {
  longestTraffic_ = longestTraffic();
  if (client_) client_->remember(memory_);
  client_.reset();
  connection_.reset();
  hasJoined_ = false;
  leaving_ = false;
  nextMove_ = now + between(1, 30);
}

Traffic SoakBot::longestTraffic() const {
  return connection_ ? longer(longestTraffic_, connection_->traffic()) : longestTraffic_;
}

std::uint64_t SoakBot::desyncs() const {
  const Session* const session = client_ ? client_->session() : nullptr;
  return (session ? session->roundStatistics() : memory_.game.rounds).desyncs;
}

std::uint64_t SoakBot::corrections() const {
  const Session* const session = client_ ? client_->session() : nullptr;
  return (session ? session->predictionStatistics() : memory_.game.prediction).corrections;
}

void SoakBot::leave(Time now) {
  drop(now);
  forget();
}

// The next session has another player.
void SoakBot::forget() {
  slot_.reset();
  memory_.token = tokenOf(number_, random_());
}

void SoakBot::fault(const std::string& what) {
  if (faults_.size() < kMaxFaults) faults_.push_back(name_ + ": " + what);
}

Traffic longer(const Traffic& a, const Traffic& b) {
  return a.sentPackets + a.receivedPackets < b.sentPackets + b.receivedPackets ? b : a;
}

}  // namespace platon
