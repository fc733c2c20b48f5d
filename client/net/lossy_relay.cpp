#include "client/net/lossy_relay.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

namespace platon {

namespace {

using Payload = std::vector<std::uint8_t>;

sockaddr_in resolve(const ServerAddress& server) {
  addrinfo wanted{};
  wanted.ai_family = AF_INET;
  wanted.ai_socktype = SOCK_DGRAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(server.port);
  if (getaddrinfo(server.host.c_str(), port.c_str(), &wanted, &found) != 0) {
    throw std::runtime_error("cannot resolve host " + server.host);
  }
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr = reinterpret_cast<const sockaddr_in*>(found->ai_addr)->sin_addr;
  address.sin_port = htons(server.port);
  freeaddrinfo(found);
  return address;
}

const sockaddr* generic(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }
sockaddr* generic(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

std::uint16_t bindToLoopback(int handle) {
  sockaddr_in own{};
  own.sin_family = AF_INET;
  own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof own;
  if (bind(handle, generic(own), size) != 0 || getsockname(handle, generic(own), &size) != 0) {
    throw std::runtime_error("cannot open a loopback port for simulated network conditions");
  }
  return ntohs(own.sin_port);
}

std::optional<Payload> receive(int handle, sockaddr_in* sender) {
  std::array<std::uint8_t, 65536> buffer;
  socklen_t size = sizeof(sockaddr_in);
  const ssize_t count = recvfrom(handle, buffer.data(), buffer.size(), 0,
                                 sender == nullptr ? nullptr : generic(*sender), sender == nullptr ? nullptr : &size);
  if (count < 0) return std::nullopt;
  return Payload(buffer.begin(), buffer.begin() + count);
}

}  // namespace

LossyRelay::LossyRelay(const ServerAddress& server, const LinkQuality& eachWay, std::uint64_t seed)
    : server_(resolve(server)), serverSide_(std::in_place), up_(eachWay, seed), down_(eachWay, ~seed) {
  port_ = bindToLoopback(clientSide_.handle);
  if (!connectToServer()) throw std::runtime_error("cannot reach " + server.text());
}

bool LossyRelay::connectToServer() const { return connect(serverSide_->handle, generic(server_), sizeof server_) == 0; }

LossyRelay::Socket::Socket() : handle(socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
  if (handle < 0) throw std::runtime_error("cannot open a UDP socket for simulated network conditions");
}

LossyRelay::Socket::~Socket() { close(handle); }

void LossyRelay::receiveFromClient(Moment now) {
  sockaddr_in sender{};
  while (std::optional<Payload> datagram = receive(clientSide_.handle, &sender)) {
    if (sender.sin_port != client_.sin_port) setClient(sender);
    up_.send(std::move(*datagram), now);
  }
}

// Separates successive connections: drops all datagrams of the old one, and uses a new socket, so
// that the server sees a new address and cannot answer the old connection over the new one.
void LossyRelay::setClient(const sockaddr_in& client) {
  const bool first = client_.sin_port == 0;
  client_ = client;
  if (first) return;
  up_.clear();
  down_.clear();
  serverSide_.emplace();
  connectToServer();  // cannot fail: the constructor has connected to the same address
}

void LossyRelay::receiveFromServer(Moment now) {
  while (std::optional<Payload> datagram = receive(serverSide_->handle, nullptr)) down_.send(std::move(*datagram), now);
}

void LossyRelay::setQuality(const LinkQuality& eachWay) {
  up_.setQuality(eachWay);
  down_.setQuality(eachWay);
}

void LossyRelay::pump(Moment now) {
  receiveFromClient(now);
  receiveFromServer(now);
  // Ignores errors: a datagram that the socket does not accept is lost.
  while (const std::optional<Payload> datagram = up_.receive(now)) {
    (void)!send(serverSide_->handle, datagram->data(), datagram->size(), 0);
  }
  while (const std::optional<Payload> datagram = down_.receive(now)) {
    (void)!sendto(clientSide_.handle, datagram->data(), datagram->size(), 0, generic(client_), sizeof client_);
  }
}

}  // namespace platon
