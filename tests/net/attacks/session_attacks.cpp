#include "tests/net/attacks/session_attacks.h"

#include <array>
#include <vector>

#include "protocol/limits.h"
#include "tests/net/attacks/flood.h"
#include "tests/net/attacks/hostile_content.h"
#include "tests/net/attacks/hostile_session.h"

namespace platon {
namespace {

constexpr auto kOwnVersion = static_cast<std::uint16_t>(kProtocolVersion);
constexpr Time kSessionLife = std::chrono::seconds(2);
constexpr std::size_t kOpenSessions = 64;

/// Sends Open with the right cookie and an invented proof of the password, from addresses that answer.
class PasswordGuesser : public Attacker {
 public:
  explicit PasswordGuesser(AttackNetwork& network) : server_(network.server()) {
    for (int i = 0; i < kOwnHouseholds; ++i) {
      hands_.push_back({network.socket(ownAddress(network.version(), i)), {}, {}});
    }
    for (Hand& hand : hands_) dice_.fill(hand.key);
  }

  void step(Time now, int datagrams) override {
    for (Hand& hand : hands_) listen(hand, now);
    for (int i = 0; i < datagrams; ++i) guess(hands_[static_cast<std::size_t>(i) % hands_.size()], now);
    for (Hand& hand : hands_) hand.socket->flush(now);
  }

 private:
  struct Hand {
    std::unique_ptr<DatagramSocket> socket;
    CryptoKey key;
    std::optional<Cookie> cookie;
  };

  static void listen(Hand& hand, Time now) {
    while (const auto datagram = hand.socket->receive(now)) {
      if (const auto reply = decodeCookieReply(datagram->bytes)) hand.cookie = reply->cookie;
    }
  }

  void guess(Hand& hand, Time now) {
    if (!hand.cookie) return hand.socket->send(server_, encode(Knock{kOwnVersion, hand.key}), now);
    Open open{*hand.cookie, {}};
    dice_.fill(open.exchange);
    std::copy(hand.key.begin(), hand.key.end(), open.exchange.begin());
    hand.socket->send(server_, encode(open), now);
  }

  SocketAddress server_;
  std::vector<Hand> hands_;
  Dice dice_;
};

/// Opens one session after another and uses none.
class SessionOpener : public Attacker {
 public:
  explicit SessionOpener(AttackNetwork& network) : network_(network) { sessions_.resize(kOpenSessions); }

  void step(Time now, int) override {
    sessions_[next_] =
        std::make_unique<ClientGate>(network_.socket(ownAddress(network_.version(), static_cast<int>(next_))),
                                     std::vector{network_.server()}, ServerKnowledge{}, KeyPair::random());
    next_ = (next_ + 1) % sessions_.size();
    for (const auto& session : sessions_) {
      if (session) advance(*session, now);
    }
  }

 private:
  static void advance(ClientGate& session, Time now) {
    session.update(now);
    session.receive(now);
    session.flush(now);
  }

  AttackNetwork& network_;
  std::vector<std::unique_ptr<ClientGate>> sessions_;
  std::size_t next_ = 0;
};

/// Has a session in each of its households, begins it again every two seconds, and sends what `next` does.
class SessionFlood : public Attacker {
 public:
  using Next = std::function<void(HostileSession&, Dice&, std::uint32_t number, Time now)>;

  SessionFlood(AttackNetwork& network, Next next) : network_(network), next_(std::move(next)) {}

  void step(Time now, int datagrams) override {
    if (sessions_.empty() || now - since_ >= kSessionLife) restart(now);
    for (const auto& session : sessions_) session->step(now);
    for (int i = 0; i < datagrams; ++i) {
      HostileSession& session = *sessions_[number_ / kHostileContents % sessions_.size()];
      if (session.peer()) next_(session, dice_, number_, now);
      ++number_;
    }
    for (const auto& session : sessions_) session->step(now);
  }

 private:
  void restart(Time now) {
    since_ = now;
    sessions_.clear();
    for (int i = 0; i < kOwnHouseholds; ++i) {
      sessions_.push_back(std::make_unique<HostileSession>(network_, ownAddress(network_.version(), begun_++)));
    }
  }

  AttackNetwork& network_;
  Next next_;
  std::vector<std::unique_ptr<HostileSession>> sessions_;
  Time since_{};
  Dice dice_;
  std::uint32_t number_ = 0;
  int begun_ = 0;  // sessions
};

}  // namespace

std::unique_ptr<Attacker> guessPasswords(AttackNetwork& network) { return std::make_unique<PasswordGuesser>(network); }

std::unique_ptr<Attacker> openSessions(AttackNetwork& network) { return std::make_unique<SessionOpener>(network); }

std::unique_ptr<Attacker> sendHostileContents(AttackNetwork& network) {
  return std::make_unique<SessionFlood>(network, [](HostileSession& session, Dice&, std::uint32_t number, Time now) {
    session.send(hostileContent(*session.peer(), number), now);
  });
}

std::unique_ptr<Attacker> sendExcess(AttackNetwork& network) {
  return std::make_unique<SessionFlood>(network, [](HostileSession& session, Dice&, std::uint32_t, Time now) {
    session.send(pingContent(*session.peer()), now);
  });
}

std::unique_ptr<Attacker> roam(AttackNetwork& network) {
  return std::make_unique<SessionFlood>(network, [&](HostileSession& session, Dice& dice, std::uint32_t, Time now) {
    session.sendFrom(anyStranger(network, dice), pingContent(*session.peer()), now);
  });
}

}  // namespace platon
