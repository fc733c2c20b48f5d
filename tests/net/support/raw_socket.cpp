#include "tests/net/support/raw_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <stdexcept>

namespace platon {
namespace {

sockaddr_in systemAddress(const std::string& ip, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  inet_pton(AF_INET, ip.c_str(), &address.sin_addr);
  return address;
}

const sockaddr* generic(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

}  // namespace

RawSocket::RawSocket(const SocketAddress& target, const char* own)
    : socket_(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  const sockaddr_in from = systemAddress(own, 0);
  const sockaddr_in to = systemAddress(target.ip.text(), target.port);
  if (bind(socket_, generic(from), sizeof from) != 0 || connect(socket_, generic(to), sizeof to) != 0) {
    throw std::runtime_error("no socket on loopback");
  }
}

RawSocket::~RawSocket() { close(socket_); }

void RawSocket::send(ByteSpan datagram) const { (void)!::send(socket_, datagram.data(), datagram.size(), 0); }

Bytes RawSocket::receive() const {
  Bytes bytes(2048);
  const ssize_t size = recv(socket_, bytes.data(), bytes.size(), 0);
  bytes.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return bytes;
}

}  // namespace platon
