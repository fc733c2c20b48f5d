#include "protocol/transport/udp_socket.h"

#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include "protocol/transport/socket_address.h"

namespace platon {
namespace {

constexpr std::size_t kBatch = 64;
// Requested from the system, which may grant less. A tick's worth of a flood of 20 000 datagrams a second fits.
constexpr int kBufferBytes = 4 * 1024 * 1024;

std::string remedyFor(int fault) {
  if (fault == EADDRINUSE) return "; stop the program that uses it or choose another port after --port";
  if (fault == EACCES) return "; choose a port above 1023 after --port";
  if (fault == EADDRNOTAVAIL) return "; choose an address of this machine after --bind, or :: for all";
  return "";
}

[[noreturn]] void refuse(const SocketAddress& own, int fault) {
  const std::string place = own.port == 0 ? own.ip.text() : own.text();
  throw SocketError("cannot listen on " + place + ": " + std::strerror(fault) + remedyFor(fault),
                    fault == EADDRINUSE ? SocketError::kFailed : SocketError::kUsage);
}

IpAddress anyOf(bool ipv6) { return *IpAddress::parse(ipv6 ? "::" : "0.0.0.0"); }

}  // namespace

// The datagrams of one system call.
struct UdpSocket::Batches {
  using Received = std::array<std::uint8_t, kMaxDatagramBytes + 1>;  // one more shows that it was longer
  struct Queued {
    std::array<std::uint8_t, kMaxDatagramBytes> bytes;
    SystemAddress receiver;
    iovec part;
  };

  std::array<Received, kBatch> received;
  std::array<SystemAddress, kBatch> senders;
  std::array<iovec, kBatch> receivedParts;
  std::array<mmsghdr, kBatch> receivedHeads{};
  std::size_t arrived = 0;  // in `received`
  std::size_t taken = 0;    // of these
  std::array<Queued, kBatch> queued;
  std::array<mmsghdr, kBatch> queuedHeads{};
  std::size_t waiting = 0;  // in `queued`

  Batches() {
    for (std::size_t i = 0; i < kBatch; ++i) receivedParts[i] = {received[i].data(), received[i].size()};
  }

  std::size_t receiveFrom(int handle) {
    for (std::size_t i = 0; i < kBatch; ++i)
      receivedHeads[i].msg_hdr = {&senders[i], sizeof(SystemAddress), &receivedParts[i], 1, nullptr, 0, 0};
    const int count = recvmmsg(handle, receivedHeads.data(), kBatch, MSG_DONTWAIT, nullptr);
    taken = 0;
    arrived = count > 0 ? static_cast<std::size_t>(count) : 0;
    return arrived;
  }
};

UdpSocket::UdpSocket(const std::string& bind, std::uint16_t port) : batches_(std::make_unique<Batches>()) {
  std::optional<IpAddress> ip = IpAddress::parse(bind);
  if (!ip) {
    throw SocketError("cannot listen on '" + bind + "': it is not an IP address; name one such as 127.0.0.1 or ::",
                      SocketError::kUsage);
  }
  open(!ip->isIpv4());
  if (handle_ < 0 && *ip == anyOf(true)) {
    ip = anyOf(false);
    open(false);
  }
  const auto fail = [&] {
    const int fault = errno;
    if (handle_ >= 0) close(handle_);
    refuse({*ip, port}, fault);
  };
  if (handle_ < 0) fail();
  if (bindTo({*ip, port})) return;
  const bool noIpv6 = errno == EADDRNOTAVAIL && *ip == anyOf(true);
  if (!noIpv6) fail();
  close(handle_);
  open(false);
  if (handle_ < 0 || !bindTo({anyOf(false), port})) fail();
}

UdpSocket::UdpSocket() : batches_(std::make_unique<Batches>()) {
  open(true);
  if (handle_ < 0) open(false);
  if (handle_ < 0) throw SocketError(std::string("cannot open a UDP socket: ") + std::strerror(errno));
}

UdpSocket::~UdpSocket() {
  if (handle_ >= 0) close(handle_);
}

void UdpSocket::allowBroadcast() {
  const int on = 1;
  setsockopt(handle_, SOL_SOCKET, SO_BROADCAST, &on, sizeof on);
}

void UdpSocket::open(bool ipv6) {
  ipv6_ = ipv6;
  handle_ = socket(ipv6 ? AF_INET6 : AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (handle_ < 0) return;
  const int off = 0;
  if (ipv6) setsockopt(handle_, IPPROTO_IPV6, IPV6_V6ONLY, &off, sizeof off);
  setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &kBufferBytes, sizeof kBufferBytes);
  setsockopt(handle_, SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof kBufferBytes);
}

bool UdpSocket::bindTo(const SocketAddress& own) const {
  SystemAddress system;
  const socklen_t size = toSystem(own, ipv6_, system);
  return bind(handle_, &system.any, size) == 0;
}

// One call of the system for many datagrams: after a call that was not filled, the socket is taken for empty once.
std::optional<Datagram> UdpSocket::receive(Time) {
  Batches& batches = *batches_;
  for (;;) {
    if (batches.taken == batches.arrived) {
      const bool wasPartial = batches.arrived != 0 && batches.arrived < kBatch;
      batches.arrived = batches.taken = 0;
      if (wasPartial || batches.receiveFrom(handle_) == 0) return std::nullopt;
    }
    const std::size_t index = batches.taken++;
    const std::size_t size = batches.receivedHeads[index].msg_len;
    return Datagram{fromSystem(batches.senders[index]), ByteSpan(batches.received[index]).first(size)};
  }
}

void UdpSocket::send(const SocketAddress& receiver, ByteSpan bytes, Time now) {
  if (bytes.empty() || bytes.size() > kMaxDatagramBytes || (!ipv6_ && !receiver.ip.isIpv4())) return;
  Batches& batches = *batches_;
  if (batches.waiting == kBatch) flush(now);
  Batches::Queued& queued = batches.queued[batches.waiting];
  std::copy(bytes.begin(), bytes.end(), queued.bytes.begin());
  queued.part = {queued.bytes.data(), bytes.size()};
  const socklen_t size = toSystem(receiver, ipv6_, queued.receiver);
  batches.queuedHeads[batches.waiting++].msg_hdr = {&queued.receiver, size, &queued.part, 1, nullptr, 0, 0};
}

// A datagram that the system does not take is lost, and the next ones are sent all the same.
void UdpSocket::flush(Time) {
  Batches& batches = *batches_;
  for (std::size_t sent = 0; sent < batches.waiting;) {
    const auto left = static_cast<unsigned>(batches.waiting - sent);
    const int count = sendmmsg(handle_, batches.queuedHeads.data() + sent, left, MSG_DONTWAIT);
    sent += count > 0 ? static_cast<std::size_t>(count) : 1;
  }
  batches.waiting = 0;
}

void UdpSocket::wait(std::chrono::milliseconds timeout) {
  pollfd socket{handle_, POLLIN, 0};
  poll(&socket, 1, static_cast<int>(timeout.count()));
}

SocketAddress UdpSocket::address() const {
  SystemAddress system{};
  socklen_t size = sizeof system;
  getsockname(handle_, &system.any, &size);
  return fromSystem(system);
}

std::vector<SocketAddress> resolve(const std::string& host, std::uint16_t port) {
  if (const auto ip = IpAddress::parse(host)) return {{*ip, port}};
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  std::vector<SocketAddress> addresses;
  if (getaddrinfo(host.c_str(), nullptr, &wanted, &found) == 0) {
    for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
      SystemAddress system{};
      std::memcpy(&system, each->ai_addr, std::min<std::size_t>(each->ai_addrlen, sizeof system));
      if (each->ai_family != AF_INET && each->ai_family != AF_INET6) continue;
      addresses.push_back(fromSystem(system));
      addresses.back().port = port;
    }
    freeaddrinfo(found);
  }
  if (addresses.empty()) throw SocketError("cannot resolve host " + host);
  return addresses;
}

}  // namespace platon
