#include "client/session/network_client.h"

#include <sodium.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <utility>

namespace platon {

namespace {

bool hasConfirmedTicks(const Session& session) {
  return session.round() != nullptr && session.round()->prediction().confirmedTicks() > 0;
}

SessionToken randomToken() {
  if (sodium_init() < 0) throw std::runtime_error("cannot get random numbers from the system");
  SessionToken token;
  randombytes_buf(token.data(), token.size());
  return token;
}

// 0 after the first answered attempt, then kFirstPause × 1, 2, 4 …
Time pauseAfter(std::uint32_t answered) {
  if (answered == 0) return Time{};
  const std::uint32_t doublings = std::min(answered - 1, 16u);
  return std::min(NetworkClient::kFirstPause * (1 << doublings), NetworkClient::kMaxPause);
}

}  // namespace

NetworkClient::NetworkClient(ServerLinks links, const Profile& profile, Time now)
    : links_(std::move(links)), profile_(profile), state_(Connecting{now}) {
  memory_.token = profile.token ? *profile.token : randomToken();
  memory_.store = profile.levels;
  memory_.observer = profile.observer;
  link_ = links_.connect(profile_.knowledge);
}

void NetworkClient::update(Time now, const Controls& controls) {
  if (const auto* paused = std::get_if<Paused>(&state_); paused != nullptr && now >= paused->until) connect(now);
  if (!link_) return;
  link_->service(now, [this, now](std::span<const std::uint8_t> message) {
    if (is<InSession>()) session_->receive(message, now);
  });
  if (is<Connecting>()) checkConnecting(now);
  if (is<InSession>()) checkSession(now);
  if (!link_ || is<Connecting>()) return;
  if (is<InSession>()) session_->update(now, controls);
  sendOutgoing();
  link_->flush(now);
}

void NetworkClient::sendOutgoing() {
  for (const OutgoingMessage& message : session_->takeOutgoing()) link_->send(message.bytes, message.reliable);
  if (is<Leaving>()) link_->close();
}

void NetworkClient::connect(Time now) {
  state_ = Connecting{now};
  try {
    link_ = links_.connect(profile_.knowledge);
  } catch (const std::runtime_error& error) {
    fail({error.what(), false}, now);
  }
}

void NetworkClient::startSession(Time now) {
  session_.emplace(profile_.name, now, memory_);
  state_ = InSession{now};
}

void NetworkClient::checkConnecting(Time now) {
  if (link_->identity()) profile_.knowledge.identity = link_->identity();
  if (link_->state() == MessageLink::State::kConnected) return startSession(now);
  if (link_->refused()) {
    asksPassword_ = link_->refused()->asksPassword;
    return fail({links_.server + ": " + link_->refused()->reason, link_->refused()->permanent}, now);
  }
  if (!closed() && now - std::get<Connecting>(state_).since <= kConnectTimeout) return;
  fail({"no answer from " + links_.server + " within 5 s: is platon-server running there?", false}, now);
}

void NetworkClient::checkSession(Time now) {
  const bool timedOut = now - std::get<InSession>(state_).since > kWelcomeTimeout;
  welcomed_ = welcomed_ || session_->welcome();  // also when the session has ended in the same call
  if (session_->ending()) return fail(*session_->ending(), now);
  if (!session_->welcome() && (closed() || timedOut)) {
    return fail({"the server at " + links_.server + " did not respond in time; try again", false}, now);
  }
  if (closed()) return fail({"lost the connection to " + links_.server, false}, now);
  if (!hasConfirmedTicks(*session_)) return;
  if (recovery_.outage) ++resumes_;
  recovery_ = Recovery();
}

// If the first attempt is not answered, there is no server. A server that answers may lose some messages.
bool NetworkClient::mayRetry(const SessionEnding& failure) const {
  if (failure.permanent) return false;
  return welcomed_ || (is<InSession>() && !session_->ending() && recovery_.failed + 1 < kMaxFirstAttempts);
}

void NetworkClient::fail(const SessionEnding& failure, Time now) {
  const bool retries = mayRetry(failure);
  if (is<InSession>()) {
    session_->connectionLost(failure.reason);
    memory_ = session_->memory();
  }
  if (retries) {
    if (!recovery_.outage || isRefused()) recovery_.outage = failure.reason;
    ++recovery_.failed;
    const Time pause = pauseAfterFailure();
    dropLink();
    state_ = Paused{now + pause};
  } else {
    if (!is<InSession>()) dropLink();
    ending_ = failure.reason;
    state_ = Ended();
  }
}

// Whether the server has answered the present attempt to join with a refusal.
bool NetworkClient::isRefused() const {
  return is<InSession>() ? session_->ending() && !session_->welcome() : link_ && link_->refused();
}

// No pause after an unanswered attempt, because its timeout is long enough.
Time NetworkClient::pauseAfterFailure() {
  const bool unanswered = link_ && is<Connecting>();
  return unanswered ? Time{} : pauseAfter(recovery_.answered++);
}

void NetworkClient::dropLink() {
  pastTraffic_ = traffic();
  link_.reset();
}

std::optional<ServerAddress> NetworkClient::next() const {
  const bool told = ending_ && session_ && session_->ending() && !session_->ending()->next.empty();
  return told ? std::optional(parseServerAddress(session_->ending()->next)) : std::nullopt;
}

void NetworkClient::setCompanion(std::uint32_t local, const std::optional<std::string>& name) {
  memory_.companions[local] = name;
  if (is<InSession>()) session_->setCompanion(local, name);
}

void NetworkClient::toggleVote() {
  if (is<InSession>()) session_->toggleVote();
}

void NetworkClient::leave() {
  if (is<InSession>()) session_->leave();
  if (is<Connecting>() || is<Paused>()) dropLink();
  state_ = Leaving();
}

std::optional<DesyncReport> NetworkClient::takeDesync() { return session_ ? session_->takeDesync() : std::nullopt; }

Traffic NetworkClient::traffic() const { return link_ ? pastTraffic_ + link_->traffic() : pastTraffic_; }

void updateUntilClosed(const Clock& clock, const std::function<void(Time)>& update,
                       const std::function<bool()>& closed) {
  const Time end = clock.now() + std::chrono::milliseconds(500);
  for (Time now = clock.now(); now < end && !closed(); now = clock.now()) {
    update(now);
    clock.sleepUntil(now + std::chrono::milliseconds(2));
  }
}

}  // namespace platon
