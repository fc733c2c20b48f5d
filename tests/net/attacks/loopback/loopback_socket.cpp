#include "tests/net/attacks/loopback/loopback_socket.h"

#include <unistd.h>

#include <array>
#include <cstring>
#include <stdexcept>

#include "protocol/transport/socket_address.h"

namespace platon {
namespace {

constexpr int kBufferBytes = 4 * 1024 * 1024;
constexpr std::size_t kMaxReceived = 2048;

// For a socket of the address's own kind.
socklen_t toSystem(const SocketAddress& address, SystemAddress& system) {
  return toSystem(address, !address.ip.isIpv4(), system);
}

// The part of a message that names its sender.
template <class Info>
struct ControlMessage {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(Info))> bytes{};

  ControlMessage(int level, int type, const Info& info) {
    cmsghdr head{};
    head.cmsg_level = level;
    head.cmsg_type = type;
    head.cmsg_len = CMSG_LEN(sizeof(Info));
    std::memcpy(bytes.data(), &head, sizeof head);
    std::memcpy(bytes.data() + CMSG_LEN(0), &info, sizeof info);
  }
};

}  // namespace

LoopbackSocket::LoopbackSocket(const IpAddress& own)
    : ipv6_(!own.isIpv4()),
      handle_(socket(ipv6_ ? AF_INET6 : AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)),
      buffer_(kMaxReceived) {
  SystemAddress system;
  const socklen_t size = toSystem(SocketAddress{own, 0}, system);
  setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &kBufferBytes, sizeof kBufferBytes);
  setsockopt(handle_, SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof kBufferBytes);
  if (bind(handle_, &system.any, size) != 0) {
    throw std::runtime_error("cannot open a socket at " + own.text());
  }
}

LoopbackSocket::~LoopbackSocket() { close(handle_); }

void LoopbackSocket::send(const SocketAddress& receiver, ByteSpan datagram) const {
  SystemAddress to;
  const socklen_t size = toSystem(receiver, to);
  sendto(handle_, datagram.data(), datagram.size(), 0, &to.any, size);
}

void LoopbackSocket::sendFrom(const IpAddress& from, const SocketAddress& receiver, ByteSpan datagram) const {
  SystemAddress sender;
  toSystem(SocketAddress{from, 0}, ipv6_, sender);
  if (ipv6_) {
    in6_pktinfo info{};
    info.ipi6_addr = sender.ipv6.sin6_addr;
    ControlMessage control(IPPROTO_IPV6, IPV6_PKTINFO, info);
    sendMessage(receiver, datagram, control.bytes);
  } else {
    in_pktinfo info{};
    info.ipi_spec_dst = sender.ipv4.sin_addr;
    ControlMessage control(IPPROTO_IP, IP_PKTINFO, info);
    sendMessage(receiver, datagram, control.bytes);
  }
}

void LoopbackSocket::sendMessage(const SocketAddress& receiver, ByteSpan datagram, std::span<char> control) const {
  SystemAddress to;
  const socklen_t size = toSystem(receiver, to);
  iovec part{const_cast<std::uint8_t*>(datagram.data()), datagram.size()};
  const msghdr message{&to, size, &part, 1, control.data(), control.size(), 0};
  sendmsg(handle_, &message, 0);
}

std::optional<Datagram> LoopbackSocket::receive() {
  SystemAddress from{};
  socklen_t size = sizeof from;
  const ssize_t bytes = recvfrom(handle_, buffer_.data(), buffer_.size(), 0, &from.any, &size);
  if (bytes < 0) return std::nullopt;
  return Datagram{fromSystem(from), ByteSpan(buffer_).first(static_cast<std::size_t>(bytes))};
}

SocketAddress LoopbackSocket::address() const {
  SystemAddress own{};
  socklen_t size = sizeof own;
  getsockname(handle_, &own.any, &size);
  return fromSystem(own);
}

}  // namespace platon
