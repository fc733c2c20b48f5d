#include "tests/net/attacks/virtual_attack.h"

#include <deque>
#include <set>

#include "client/net/enet_link.h"
#include "client/session/session.h"
#include "client/time/steady_now.h"
#include "tests/net/support/pressing.h"

namespace platon {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

// Until the attack begins. Clients need some seconds to find the smallest lead without missed inputs.
constexpr Time kWarmUp = seconds(12);
constexpr Time kAttack = seconds(4);
constexpr Time kNewcomer = seconds(1);  // after the begin of the attack
constexpr Time kFrame = milliseconds(4);
constexpr Time kTick = microseconds(16667);
constexpr int kDatagramsPerStep = 20;
constexpr std::size_t kHonest = 4;

/// The simulated network as the attacker has it.
class VirtualAttackNetwork : public AttackNetwork {
 public:
  VirtualAttackNetwork(DatagramNetwork& network, const SocketAddress& server) : network_(network), server_(server) {
    network_.setFilter([this](const DatagramNetwork::Sent& sent) {
      listen(sent);
      return true;
    });
  }
  ~VirtualAttackNetwork() override { network_.setFilter({}); }

  void send(const SocketAddress& from, ByteSpan datagram) override {
    ++sent_;
    noteSent(datagram.size());
    bytesFrom_[from] += datagram.size();
    network_.inject(from, server_, datagram);
  }
  std::unique_ptr<DatagramSocket> socket(const IpAddress& own) override {
    const SocketAddress address{own, ++lastPort_};
    own_.insert(address);
    return network_.socket(address);
  }
  SocketAddress server() const override { return server_; }

  void addVictim(const SocketAddress& victim) { victims_.insert(victim); }
  bool isVictim(const SocketAddress& address) const { return victims_.contains(address); }
  const std::set<SocketAddress>& victims() const { return victims_; }
  std::uint64_t sent() const { return sent_; }
  /// Bytes that the attacker has sent in each name.
  const std::map<SocketAddress, std::uint64_t>& bytesFrom() const { return bytesFrom_; }

 private:
  void listen(const DatagramNetwork::Sent& sent) {
    if (isVictim(sent.from)) return note(sent.from, true, sent.bytes);
    if (isVictim(sent.to)) return note(sent.to, false, sent.bytes);
    if (own_.contains(sent.to) || bytesFrom_.contains(sent.to)) noteReceived(sent.bytes.size());
    if (!own_.contains(sent.from)) return;
    ++sent_;
    noteSent(sent.bytes.size());
  }

  DatagramNetwork& network_;
  SocketAddress server_;
  std::set<SocketAddress> victims_;
  std::set<SocketAddress> own_;
  std::map<SocketAddress, std::uint64_t> bytesFrom_;
  std::uint64_t sent_ = 0;
  std::uint16_t lastPort_ = 1024;
};

/// A player of ours.
class HonestPlayer {
 public:
  HonestPlayer(DatagramNetwork& network, const SocketAddress& own, const SocketAddress& server,
               const std::string& password, int number)
      : connection_(network.socket(own), {server}, {std::nullopt, password}),
        name_("honest " + std::to_string(number)),
        controls_(pressing(static_cast<std::uint64_t>(number))) {}

  void update(Time now) {
    connection_.service(now, [&](std::span<const std::uint8_t> message) {
      if (session_) session_->receive(message, now);
    });
    if (!session_ && connection_.state() == EnetLink::State::kConnected) {
      session_.emplace(name_, now, memory());
    }
    if (!session_) return;
    session_->update(now, controls_);
    for (const OutgoingMessage& message : session_->takeOutgoing()) connection_.send(message.bytes, message.reliable);
    connection_.flush(now);
  }

  std::uint64_t confirmedTicks() const { return session_ ? session_->predictionStatistics().confirmedTicks : 0; }
  std::uint64_t missedInputs() const { return session_ ? session_->predictionStatistics().missedInputs : 0; }
  bool hasJoined() const {
    return session_ && session_->round() != nullptr && session_->round()->prediction().present();
  }
  bool hasEnded() const {
    return connection_.state() == EnetLink::State::kClosed || (session_ && session_->ending().has_value());
  }
  std::uint32_t desyncs() const { return session_ ? session_->roundStatistics().desyncs : 0; }

 private:
  Session::Memory memory() const {
    Session::Memory memory;
    memory.token.emplace();
    std::copy(name_.begin(), name_.end(), memory.token->begin());
    return memory;
  }

  EnetLink connection_;
  std::string name_;
  Controls controls_;
  std::optional<Session> session_;  // once connected
};

/// Server, players and attacker.
class Scene {
 public:
  Scene(const Attack* attack, std::string password)
      : password_(std::move(password)),
        version_(attack == nullptr ? IpVersion::kIpv4 : attack->version),
        server_(network_, serverSocket_, password_),
        attackNetwork_(network_, serverSocket_) {
    for (std::size_t i = 0; i < kHonest; ++i) addPlayer();
    run(kWarmUp);
    ticksBefore_ = sumOf(&HonestPlayer::confirmedTicks);
    missedBefore_ = sumOf(&HonestPlayer::missedInputs);
    victimBytesBefore_ = bytesToVictims();
    server_.resetHeap();
    if (attack == nullptr) return;
    attacker_ = attack->start(attackNetwork_);
    amplifies_ = attack->amplifies;
  }

  Damage run() {
    run(kNewcomer);
    addPlayer();
    const Time since = now_;
    for (const Time end = now_ + kAttack - kNewcomer; now_ < end;) {
      step();
      if (!damage_.joinTime && players_.back().hasJoined()) damage_.joinTime = now_ - since;
    }
    if (amplifies_) amplify();
    return conclude();
  }

 private:
  void addPlayer() {
    const int number = static_cast<int>(players_.size()) + 1;
    const SocketAddress own{playerAddress(version_, number), 5000};
    players_.emplace_back(network_, own, serverSocket_, password_, number);
    if (players_.size() <= kHonest) attackNetwork_.addVictim(own);
  }

  void run(Time duration) {
    for (const Time end = now_ + duration; now_ < end;) step();
  }

  void amplify() {
    run(kAmplifyingBegins - kAttack);
    const Exchange before = attackNetwork_.exchange();
    run(kAmplifyingLasts);
    damage_.late = attackNetwork_.exchange() - before;
  }

  void step() {
    now_ += milliseconds(1);
    if (attacker_) attacker_->step(now_, kDatagramsPerStep);
    if (now_ >= nextFrame_) {
      nextFrame_ += kFrame;
      for (HonestPlayer& player : players_) player.update(now_);
    }
    if (now_ < nextTick_) return;
    nextTick_ += kTick;
    server_.tick(now_);
    damage_.maxPlayers = std::max(damage_.maxPlayers, server_.server().match().players());
  }

  // Of the four.
  std::uint64_t sumOf(std::uint64_t (HonestPlayer::*count)() const) const {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < kHonest; ++i) sum += (players_[i].*count)();
    return sum;
  }

  // To the four.
  std::uint64_t bytesToVictims() const {
    std::uint64_t sum = 0;
    for (const SocketAddress& victim : attackNetwork_.victims()) sum += server_.bytesTo(victim);
    return sum;
  }

  Damage conclude() {
    damage_.ticks = sumOf(&HonestPlayer::confirmedTicks) - ticksBefore_;
    damage_.missedInputs = sumOf(&HonestPlayer::missedInputs) - missedBefore_;
    for (const HonestPlayer& player : players_) {
      damage_.disconnected += player.hasEnded() ? 1 : 0;
      damage_.desyncs += player.desyncs();
    }
    damage_.heapGrowth = server_.heapGrowth();
    damage_.rounds = server_.server().match().round();
    damage_.sent = attackNetwork_.sent();
    countAnswers();
    for (const Rejection& rejection : server_.server().host().rejections().list()) {
      const bool held = rejection.reason == "unconfirmed" || rejection.reason == "idle" || rejection.reason == "full";
      damage_.heldPlaces += held ? rejection.count : 0;
      damage_.rejected[std::string(rejection.reason)] = rejection.count;
    }
    return damage_;
  }

  void countAnswers() {
    damage_.bytesToVictims = bytesToVictims() - victimBytesBefore_;
    for (const auto& [address, bytes] : attackNetwork_.bytesFrom()) {
      if (attackNetwork_.isVictim(address)) {
        damage_.bytesAsVictims += bytes;
      } else if (address != serverSocket_) {
        damage_.amplified += server_.bytesTo(address) > bytes ? 1 : 0;
      }
    }
  }

  std::string password_;
  IpVersion version_;
  SocketAddress serverSocket_{serverAddress(version_), 7777};
  Time now_ = steadyClock().now();  // where the clock of the server begins
  Time nextFrame_ = now_;
  Time nextTick_ = now_;
  DatagramNetwork network_;
  AttackedServer server_;
  VirtualAttackNetwork attackNetwork_;
  std::deque<HonestPlayer> players_;
  std::unique_ptr<Attacker> attacker_;
  bool amplifies_ = false;
  std::uint64_t ticksBefore_ = 0;
  std::uint64_t missedBefore_ = 0;
  std::uint64_t victimBytesBefore_ = 0;
  Damage damage_;
};

}  // namespace

Damage attackVirtually(const Attack* attack, const std::string& password) { return Scene(attack, password).run(); }

}  // namespace platon
