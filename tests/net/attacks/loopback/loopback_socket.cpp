#include "tests/net/attacks/loopback/loopback_socket.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <stdexcept>

namespace platon {
namespace {

constexpr std::size_t kIpv4At = 12;
constexpr int kBufferBytes = 4 * 1024 * 1024;
constexpr std::size_t kMaxReceived = 2048;

// Either family; `ipv4.sin_family` tells which.
union SystemAddress {
  sockaddr any;
  sockaddr_in ipv4;
  sockaddr_in6 ipv6;
};

in_addr toSystem4(const IpAddress& ip) {
  in_addr address{};
  std::memcpy(&address, ip.bytes.data() + kIpv4At, sizeof address);
  return address;
}

in6_addr toSystem6(const IpAddress& ip) {
  in6_addr address{};
  std::memcpy(&address, ip.bytes.data(), sizeof address);
  return address;
}

SystemAddress toSystem(const SocketAddress& address) {
  SystemAddress system{};
  if (address.ip.isIpv4()) {
    system.ipv4 = {AF_INET, htons(address.port), toSystem4(address.ip), {}};
  } else {
    system.ipv6 = {AF_INET6, htons(address.port), 0, toSystem6(address.ip), 0};
  }
  return system;
}

socklen_t sizeOf(const SystemAddress& system) {
  return system.any.sa_family == AF_INET ? sizeof system.ipv4 : sizeof system.ipv6;
}

SocketAddress fromSystem(const SystemAddress& system) {
  SocketAddress address;
  if (system.any.sa_family == AF_INET) {
    address.ip.bytes[10] = address.ip.bytes[11] = 0xff;
    std::memcpy(address.ip.bytes.data() + kIpv4At, &system.ipv4.sin_addr, sizeof system.ipv4.sin_addr);
    address.port = ntohs(system.ipv4.sin_port);
  } else {
    std::memcpy(address.ip.bytes.data(), &system.ipv6.sin6_addr, sizeof system.ipv6.sin6_addr);
    address.port = ntohs(system.ipv6.sin6_port);
  }
  return address;
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
  const SystemAddress system = toSystem(SocketAddress{own, 0});
  setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &kBufferBytes, sizeof kBufferBytes);
  setsockopt(handle_, SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof kBufferBytes);
  if (bind(handle_, &system.any, sizeOf(system)) != 0) {
    throw std::runtime_error("cannot open a socket at " + own.text());
  }
}

LoopbackSocket::~LoopbackSocket() { close(handle_); }

void LoopbackSocket::send(const SocketAddress& receiver, ByteSpan datagram) const {
  const SystemAddress to = toSystem(receiver);
  sendto(handle_, datagram.data(), datagram.size(), 0, &to.any, sizeOf(to));
}

void LoopbackSocket::sendFrom(const IpAddress& from, const SocketAddress& receiver, ByteSpan datagram) const {
  if (ipv6_) {
    in6_pktinfo info{};
    info.ipi6_addr = toSystem6(from);
    ControlMessage control(IPPROTO_IPV6, IPV6_PKTINFO, info);
    sendMessage(receiver, datagram, control.bytes);
  } else {
    in_pktinfo info{};
    info.ipi_spec_dst = toSystem4(from);
    ControlMessage control(IPPROTO_IP, IP_PKTINFO, info);
    sendMessage(receiver, datagram, control.bytes);
  }
}

void LoopbackSocket::sendMessage(const SocketAddress& receiver, ByteSpan datagram, std::span<char> control) const {
  SystemAddress to = toSystem(receiver);
  iovec part{const_cast<std::uint8_t*>(datagram.data()), datagram.size()};
  const msghdr message{&to, sizeOf(to), &part, 1, control.data(), control.size(), 0};
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
