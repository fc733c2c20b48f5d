#include "tests/net/attacks/hostile_server.h"

#include <algorithm>

#include "tests/net/attacks/heap_bytes.h"
#include "tests/support/test_levels.h"

namespace platon {
namespace {

const SocketAddress kServer = addressAt("198.51.100.1", 7777);
const SocketAddress kClient = addressAt("192.0.2.1", 4000);

}  // namespace

HostileServer::HostileServer()
    : host_(network_.socket(kServer), ServerIdentity::random(), {}, now_),
      clientSocket_(new BufferedSocket(network_.socket(kClient))),
      client_(std::unique_ptr<DatagramSocket>(clientSocket_), {kServer}, {}) {}

void HostileServer::run(std::chrono::milliseconds time, const Attack& attack) {
  for (const Time end = now_ + time; now_ < end && !(session_ && session_->ending());) step(attack);
}

void HostileServer::step(const Attack& attack) {
  now_ += std::chrono::milliseconds(1);
  serve();
  if (joined_) {
    attack(*this);
    ++calls_;
  }
  host_.flush(now_);
  stepClient();
}

void HostileServer::serve() {
  for (const HostEvent& event : host_.service(now_)) {
    if (event.disconnected) continue;
    joined_ = event.client;
    host_.admit(event.client);
  }
}

void HostileServer::stepClient() {
  clientSocket_->fetch(now_);
  if (joined_) {
    const HeapGauge gauge(heap_);
    updateClient();
  } else {
    updateClient();
  }
  highest_ = std::max(highest_, heap_);
  clientSocket_->deliver(now_, [](const SocketAddress&, ByteSpan) {});
}

void HostileServer::updateClient() {
  client_.service(now_, [this](std::span<const std::uint8_t> message) {
    if (session_) session_->receive(message, now_);
  });
  if (!session_ && isConnected()) session_.emplace("victim", now_);
  if (!session_) return;
  session_->update(now_, controls_);
  for (const OutgoingMessage& message : session_->takeOutgoing()) client_.send(message.bytes, message.reliable);
  client_.flush(now_);
}

bool HostileServer::send(bool reliable, ByteSpan message) {
  if (!joined_ || (reliable && host_.room(*joined_) == 0)) return false;
  host_.send(*joined_, reliable, message);
  return true;
}

void HostileServer::welcome() {
  const auto level = endlessLevel();
  const Bytes text(level->text.begin(), level->text.end());
  send(Welcome{0, 1, level->hash, kMaxPlayers, kTicksPerSecond, ""});
  send(LevelChunk{level->hash, static_cast<std::uint32_t>(text.size()), 0, text});
}

void HostileServer::sendDatagram(ByteSpan datagram) { network_.inject(kServer, kClient, datagram); }

}  // namespace platon
