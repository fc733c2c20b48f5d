#include "protocol/transport/enet_calls.h"

#include <array>
#include <cassert>
#include <cstring>

namespace platon {
namespace {

thread_local EnetPort* currentPort = nullptr;
thread_local enet_uint32 currentTime = 0;

/// Receives nothing and notes whether it was asked.
class Probe : public EnetPort {
 public:
  void sendFromEnet(const ENetAddress&, ByteSpan) override { sent_ = true; }
  std::optional<Received> receiveForEnet() override {
    asked_ = true;
    return std::nullopt;
  }
  bool wasUsed() const { return sent_ && asked_; }

 private:
  bool sent_ = false;
  bool asked_ = false;
};

}  // namespace

EnetScope::EnetScope(EnetPort& port, Moment now) : outer_(currentPort), outerTime_(currentTime) {
  currentPort = &port;
  currentTime = static_cast<enet_uint32>(now / std::chrono::milliseconds(1));
}

EnetScope::~EnetScope() {
  currentPort = outer_;
  currentTime = outerTime_;
}

bool enetUsesOurCalls() {
  Probe probe;
  constexpr Moment kTime = std::chrono::milliseconds(12345);
  const EnetScope scope(probe, kTime);
  ENetHost* const host = enet_host_create(nullptr, 1, 1, 0, 0);
  if (host == nullptr) return true;  // there is no socket; the cause is found when a connection is made
  const ENetAddress nobody{1, 1};
  enet_host_connect(host, &nobody, 1, 0);
  enet_host_service(host, nullptr, 0);
  const bool used = probe.wasUsed() && host->serviceTime == 12345;
  enet_host_destroy(host);
  return used;
}

}  // namespace platon

extern "C" {

int enet_socket_send(ENetSocket, const ENetAddress* address, const ENetBuffer* buffers, size_t bufferCount) {
  assert(platon::currentPort != nullptr && address != nullptr);
  std::array<std::uint8_t, ENET_PROTOCOL_MAXIMUM_MTU> datagram;
  std::size_t size = 0;
  for (size_t i = 0; i < bufferCount; ++i) {
    if (buffers[i].dataLength > datagram.size() - size) return -1;
    std::memcpy(datagram.data() + size, buffers[i].data, buffers[i].dataLength);
    size += buffers[i].dataLength;
  }
  platon::currentPort->sendFromEnet(*address, platon::ByteSpan(datagram).first(size));
  return static_cast<int>(size);
}

// ENet takes 0 for "nothing waits".
int enet_socket_receive(ENetSocket, ENetAddress* address, ENetBuffer* buffers, size_t bufferCount) {
  assert(platon::currentPort != nullptr && bufferCount == 1);
  (void)bufferCount;
  const auto received = platon::currentPort->receiveForEnet();
  if (!received || received->bytes.size() > buffers[0].dataLength) return 0;
  std::memcpy(buffers[0].data, received->bytes.data(), received->bytes.size());
  *address = received->session;
  return static_cast<int>(received->bytes.size());
}

enet_uint32 enet_time_get() { return platon::currentTime; }

}  // extern "C"
