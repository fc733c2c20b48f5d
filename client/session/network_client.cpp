#include "client/session/network_client.h"

#include <sodium.h>

#include <algorithm>
#include <stdexcept>

namespace platon {

namespace {

bool plays(const Session& session) {
  return session.round() != nullptr && session.round()->prediction().confirmedTicks() > 0;
}

SessionToken freshToken() {
  if (sodium_init() < 0) throw std::runtime_error("this system gives no random numbers");
  SessionToken token;
  randombytes_buf(token.data(), token.size());
  return token;
}

// At once, then after 1, 2, 4 … first pauses.
Moment pauseAfter(std::uint32_t answers) {
  if (answers == 0) return Moment{};
  const std::uint32_t doublings = std::min(answers - 1, 16u);
  return std::min(NetworkClient::kFirstPause * (1 << doublings), NetworkClient::kLongestPause);
}

}  // namespace

NetworkClient::NetworkClient(const ServerAddress& server, const std::string& name, Moment now,
                             const std::optional<ServerAddress>& way, const std::optional<SessionToken>& token)
    : server_(server), name_(name), waitingSince_(now) {
  memory_.token = token ? *token : freshToken();
  connection_.emplace(way.value_or(server), now);
  way_ = connection_->address();  // to look up a name takes long when there is no network
}

void NetworkClient::update(Moment now, const Controls& controls) {
  if (retryAt_ && now >= *retryAt_ && !leaving_) connect(now);
  if (!connection_) return;
  connection_->service(now, [this, now](std::span<const std::uint8_t> message) {
    if (greeted_) session_->receive(message, now);
  });
  if (!greeted_ && connection_->state() == Connection::State::kConnected) greet(now);
  if (!ending_ && !leaving_) watch(now);
  if (!connection_ || !greeted_) return;
  if (!leaving_ && !ending_) session_->update(now, controls);
  forward();
  connection_->flush(now);
}

void NetworkClient::forward() {
  for (const OutgoingMessage& message : session_->takeOutgoing()) connection_->send(message.bytes, message.reliable);
  if (leaving_) connection_->close();
}

void NetworkClient::connect(Moment now) {
  retryAt_.reset();
  waitingSince_ = now;
  try {
    connection_.emplace(way_, now);
  } catch (const std::runtime_error& error) {
    lose({error.what(), false}, now);
  }
}

void NetworkClient::greet(Moment now) {
  session_.emplace(name_, now, memory_);
  greeted_ = true;
  waitingSince_ = now;
}

void NetworkClient::watch(Moment now) {
  if (const std::optional<Session::Ending> found = trouble(now)) return lose(*found, now);
  welcomed_ = welcomed_ || (greeted_ && session_->welcome());
  if (!greeted_ || !plays(*session_)) return;
  attempts_ = answers_ = 0;
  if (!outage_) return;
  outage_.reset();
  ++resumes_;
}

std::optional<Session::Ending> NetworkClient::trouble(Moment now) const {
  if (greeted_ && session_->ending()) return session_->ending();
  const bool welcomed = greeted_ && session_->welcome();
  const Moment patience = greeted_ ? kGreetingPatience : kPatience;
  if (!welcomed && (closed() || now - waitingSince_ > patience)) {
    const std::string known = greeted_
                                  ? "the server at " + server_.text() + " does not answer a greeting; try again"
                                  : "no answer from " + server_.text() + " within 5 s: is platon-server running there?";
    return Session::Ending{known, false};
  }
  if (closed()) return Session::Ending{"the connection to " + server_.text() + " is lost", false};
  return std::nullopt;
}

// A server of which nothing was heard is not there; one that answers may take some repetitions on a bad line.
bool NetworkClient::mayRetry(const Session::Ending& trouble) const {
  if (trouble.forGood) return false;
  return welcomed_ || (greeted_ && !session_->ending() && attempts_ + 1 < kFirstAttempts);
}

void NetworkClient::lose(const Session::Ending& trouble, Moment now) {
  const bool again = mayRetry(trouble);
  if (greeted_) {
    session_->lose(trouble.reason);
    memory_ = session_->memory();
  }
  if (!again) {
    ending_ = trouble.reason;
    return;
  }
  if (!outage_) outage_ = trouble.reason;
  ++attempts_;
  retryAt_ = now + pauseAfterLoss();
  drop();
}

// Where nobody answers there is nobody to spare, and the patience was the pause.
Moment NetworkClient::pauseAfterLoss() {
  const bool unanswered = connection_ && !greeted_;
  return unanswered ? Moment{} : pauseAfter(answers_++);
}

void NetworkClient::drop() {
  before_ = traffic();
  connection_.reset();
  greeted_ = false;
}

void NetworkClient::leave() {
  leaving_ = true;
  if (session_) session_->leave();
  if (!greeted_) drop();
}

std::optional<DesyncReport> NetworkClient::takeDesync() { return session_ ? session_->takeDesync() : std::nullopt; }

Traffic NetworkClient::traffic() const { return connection_ ? before_ + connection_->traffic() : before_; }

}  // namespace platon
