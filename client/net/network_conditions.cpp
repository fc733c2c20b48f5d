#include "client/net/network_conditions.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace platon {

namespace {

constexpr double kMinRate = 0.001;

Time milliseconds(double count) { return Time(static_cast<Time::rep>(count * 1000)); }

}  // namespace

bool LinkQuality::perfect() const {
  return lossPercent <= 0 && burstLossPercent <= 0 && delayMs <= 0 && jitterMs <= 0 && duplicatePercent <= 0 &&
         reorderPercent <= 0 && kilobytesPerSecond <= 0 && corruptPercent <= 0;
}

void NetworkConditions::send(std::vector<std::uint8_t> datagram, Time now) {
  const std::optional<Time> passed = passBottleneck(datagram.size(), now);
  if (!passed) return;
  // The burst state changes with each datagram, even if it is lost for another reason.
  const bool inBurst = drawBurst();
  if (chance(quality_.lossPercent) || inBurst) return;
  const Time due = dueTime(*passed);
  if (chance(quality_.duplicatePercent)) deliverAt(datagram, due);
  deliverAt(std::move(datagram), due);
}

std::optional<Time> NetworkConditions::passBottleneck(std::size_t bytes, Time now) {
  if (quality_.kilobytesPerSecond <= 0) return now;
  const Time turn = std::max(now, freeAt_);
  if (turn - now > kMaxQueueTime) return std::nullopt;
  freeAt_ = turn + milliseconds(static_cast<double>(bytes) / std::max(quality_.kilobytesPerSecond, kMinRate));
  return freeAt_;
}

bool NetworkConditions::drawBurst() {
  const double share = quality_.burstLossPercent / 100;
  if (share <= 0) return false;
  const double odds = share / (1 - share);
  const double length = std::max({quality_.burstLength, odds, 1.0});
  inBurst_ = draw() < (inBurst_ ? 1 - 1 / length : std::min(odds / std::max(quality_.burstLength, 1.0), 1.0));
  return inBurst_;
}

Time NetworkConditions::dueTime(Time now) {
  const Time due = now + milliseconds(quality_.delayMs + draw() * quality_.jitterMs);
  if (chance(quality_.reorderPercent)) return due + kReorderDelay;
  lastDue_ = std::max(lastDue_, due);
  return lastDue_;
}

void NetworkConditions::deliverAt(std::vector<std::uint8_t> datagram, Time due) {
  if (quality_.corruptPercent > 0 && chance(quality_.corruptPercent)) corrupt(datagram);
  const auto place = std::upper_bound(inFlight_.begin(), inFlight_.end(), due,
                                      [](Time moment, const InFlight& other) { return moment < other.due; });
  inFlight_.insert(place, {due, std::move(datagram)});
}

void NetworkConditions::corrupt(std::vector<std::uint8_t>& datagram) {
  if (datagram.empty()) return;
  const std::uint64_t bit = random_() % (datagram.size() * 8);
  datagram[bit / 8] ^= static_cast<std::uint8_t>(1u << bit % 8);
}

std::optional<std::vector<std::uint8_t>> NetworkConditions::receive(Time now) {
  if (inFlight_.empty() || inFlight_.front().due > now) return std::nullopt;
  std::vector<std::uint8_t> datagram = std::move(inFlight_.front().datagram);
  inFlight_.erase(inFlight_.begin());
  return datagram;
}

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

void LossyRelay::receiveFromClient(Time now) {
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

void LossyRelay::receiveFromServer(Time now) {
  while (std::optional<Payload> datagram = receive(serverSide_->handle, nullptr)) down_.send(std::move(*datagram), now);
}

void LossyRelay::setQuality(const LinkQuality& eachWay) {
  up_.setQuality(eachWay);
  down_.setQuality(eachWay);
}

void LossyRelay::pump(Time now) {
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
