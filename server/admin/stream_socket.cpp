#include "server/admin/stream_socket.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <optional>

#include "protocol/files/text_file.h"
#include "protocol/transport/socket_address.h"

namespace platon {
namespace {

constexpr int kBacklog = 16;

bool wouldWait() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

std::optional<uid_t> userOfPeer(const Descriptor& socket) {
  ucred peer{};
  socklen_t length = sizeof peer;
  const bool known = getsockopt(socket.number(), SOL_SOCKET, SO_PEERCRED, &peer, &length) == 0;
  return known ? std::optional(peer.uid) : std::nullopt;
}

}  // namespace

Descriptor connectUnix(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    errno = ENAMETOOLONG;
    return Descriptor();
  }
  path.copy(address.sun_path, path.size());
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const bool connected =
      socket && connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  return connected ? std::move(socket) : Descriptor();
}

bool peerIsTrusted(const Descriptor& socket) {
  const std::optional<uid_t> user = userOfPeer(socket);
  return user && (*user == geteuid() || *user == 0);
}

bool listenerIsTrusted(const Descriptor& socket, const std::string& path) {
  if (peerIsTrusted(socket)) return true;
  struct stat folder {};
  if (geteuid() != 0 || stat(folderOf(path).c_str(), &folder) != 0) return false;
  const bool closed = (folder.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  return closed && userOfPeer(socket) == folder.st_uid;
}

bool waitFor(const Descriptor& socket, bool sends, std::chrono::milliseconds limit) {
  pollfd waiting{socket.number(), static_cast<short>(sends ? POLLIN | POLLOUT : POLLIN), 0};
  return poll(&waiting, 1, static_cast<int>(limit.count())) > 0;
}

Descriptor connectTcp(const SocketAddress& address, std::chrono::milliseconds limit) {
  SystemAddress system;
  const socklen_t length = toSystem(address, !address.ip.isIpv4(), system);
  Descriptor socket(::socket(system.any.sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket || connect(socket.number(), &system.any, length) == 0) return socket;
  if (errno != EINPROGRESS) return Descriptor();
  int fault = waitFor(socket, true, limit) ? 0 : ETIMEDOUT;
  socklen_t size = sizeof fault;
  if (fault == 0) getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &fault, &size);
  errno = fault;
  return fault == 0 ? std::move(socket) : Descriptor();
}

Descriptor listenTcp(const SocketAddress& address) {
  SystemAddress system;
  const socklen_t length = toSystem(address, !address.ip.isIpv4(), system);
  Descriptor socket(::socket(system.any.sa_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!socket) return socket;
  const int yes = 1;
  setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (!address.ip.isIpv4()) setsockopt(socket.number(), IPPROTO_IPV6, IPV6_V6ONLY, &yes, sizeof yes);
  const bool listens = bind(socket.number(), &system.any, length) == 0 && listen(socket.number(), kBacklog) == 0;
  return listens ? std::move(socket) : Descriptor();
}

std::uint16_t portOf(const Descriptor& listener) {
  SystemAddress system{};
  socklen_t length = sizeof system;
  return getsockname(listener.number(), &system.any, &length) == 0 ? fromSystem(system).port : 0;
}

// The server asks often. accept4 prepares a file before it finds that nobody has connected; poll does not.
Descriptor acceptFrom(const Descriptor& listener) {
  pollfd waiting{listener.number(), POLLIN, 0};
  if (poll(&waiting, 1, 0) <= 0) return Descriptor();
  return Descriptor(accept4(listener.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
}

Received receiveFrom(const Descriptor& socket) {
  std::array<char, kMaxReceivedBytes> buffer;
  const ssize_t count = recv(socket.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count > 0) return {std::string(buffer.data(), static_cast<std::size_t>(count)), false};
  return {{}, count == 0 || !wouldWait()};
}

bool sendTo(const Descriptor& socket, std::string& bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(socket.number(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0) return wouldWait();
    bytes.erase(0, static_cast<std::size_t>(count));
  }
  return true;
}

void finishSending(const Descriptor& socket) { shutdown(socket.number(), SHUT_WR); }

}  // namespace platon
