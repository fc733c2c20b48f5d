#include "tests/net/attacks/loopback_socket.h"

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

in_addr toSystem(const IpAddress& ip) {
  in_addr address{};
  std::memcpy(&address, ip.bytes.data() + kIpv4At, sizeof address);
  return address;
}

sockaddr_in toSystem(const SocketAddress& address) {
  sockaddr_in system{};
  system.sin_family = AF_INET;
  system.sin_port = htons(address.port);
  system.sin_addr = toSystem(address.ip);
  return system;
}

SocketAddress fromSystem(const sockaddr_in& system) {
  SocketAddress address;
  address.ip.bytes[10] = address.ip.bytes[11] = 0xff;
  std::memcpy(address.ip.bytes.data() + kIpv4At, &system.sin_addr, sizeof system.sin_addr);
  address.port = ntohs(system.sin_port);
  return address;
}

}  // namespace

LoopbackSocket::LoopbackSocket(const IpAddress& own)
    : handle_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)), buffer_(kMaxReceived) {
  const sockaddr_in system = toSystem(SocketAddress{own, 0});
  setsockopt(handle_, SOL_SOCKET, SO_RCVBUF, &kBufferBytes, sizeof kBufferBytes);
  setsockopt(handle_, SOL_SOCKET, SO_SNDBUF, &kBufferBytes, sizeof kBufferBytes);
  if (bind(handle_, reinterpret_cast<const sockaddr*>(&system), sizeof system) != 0) {
    throw std::runtime_error("cannot open a socket at " + own.text());
  }
}

LoopbackSocket::~LoopbackSocket() { close(handle_); }

void LoopbackSocket::send(const SocketAddress& receiver, ByteSpan datagram) const {
  const sockaddr_in to = toSystem(receiver);
  sendto(handle_, datagram.data(), datagram.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
}

void LoopbackSocket::sendFrom(const IpAddress& from, const SocketAddress& receiver, ByteSpan datagram) const {
  sockaddr_in to = toSystem(receiver);
  iovec part{const_cast<std::uint8_t*>(datagram.data()), datagram.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(in_pktinfo))> control{};
  msghdr message{&to, sizeof to, &part, 1, control.data(), control.size(), 0};
  cmsghdr* const head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = IPPROTO_IP;
  head->cmsg_type = IP_PKTINFO;
  head->cmsg_len = CMSG_LEN(sizeof(in_pktinfo));
  in_pktinfo info{};
  info.ipi_spec_dst = toSystem(from);
  std::memcpy(CMSG_DATA(head), &info, sizeof info);
  sendmsg(handle_, &message, 0);
}

std::optional<Datagram> LoopbackSocket::receive() {
  sockaddr_in from{};
  socklen_t size = sizeof from;
  const ssize_t bytes = recvfrom(handle_, buffer_.data(), buffer_.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
  if (bytes < 0) return std::nullopt;
  return Datagram{fromSystem(from), ByteSpan(buffer_).first(static_cast<std::size_t>(bytes))};
}

SocketAddress LoopbackSocket::address() const {
  sockaddr_in own{};
  socklen_t size = sizeof own;
  getsockname(handle_, reinterpret_cast<sockaddr*>(&own), &size);
  return fromSystem(own);
}

}  // namespace platon
