#include "server/admin/metrics_server.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <utility>

#include "protocol/program_error.h"
#include "server/admin/http.h"
#include "server/admin/stream_socket.h"

namespace platon {
namespace {

constexpr std::string_view kPath = "/metrics";
constexpr std::string_view kContentType = "text/plain; version=0.0.4";
constexpr int kMaxAcceptsPerPoll = 4;

std::string remedyFor(int fault) {
  if (fault == EADDRINUSE) return "; stop the program that uses it or choose another port after --metrics";
  if (fault == EACCES) return "; choose a port above 1023 after --metrics";
  return "; choose an address of this machine after --metrics";
}

}  // namespace

std::optional<SocketAddress> parseSocketAddress(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || text.find('\0') != std::string_view::npos) return std::nullopt;
  std::string_view host = text.substr(0, colon);
  const std::string_view number = text.substr(colon + 1);
  const bool bracketed = host.starts_with('[') && host.ends_with(']');
  if (bracketed) host = host.substr(1, host.size() - 2);
  const auto ip = IpAddress::parse(host);
  if (!ip || bracketed != (host.find(':') != std::string_view::npos)) return std::nullopt;
  SocketAddress address{*ip, 0};
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), address.port);
  if (error != std::errc() || end != number.data() + number.size()) return std::nullopt;
  return address;
}

MetricsServer::MetricsServer(const SocketAddress& address) : address_(address), listener_(listenTcp(address)) {
  if (!listener_) {
    const int fault = errno;
    const std::string place = address.port == 0 ? address.ip.text() : address.text();
    throw ProgramError(fault == EADDRINUSE ? ProgramError::kFailed : ProgramError::kUsage,
                       "cannot serve metrics on " + place + ": " + std::strerror(fault) + remedyFor(fault));
  }
  address_.port = portOf(listener_);
}

void MetricsServer::poll(TimePoint now, const std::function<std::string()>& text) {
  accept(now);
  for (Connection& connection : connections_) serve(connection, now, text);
  std::erase_if(connections_, [](const Connection& connection) { return !connection.socket; });
}

void MetricsServer::accept(TimePoint now) {
  for (int i = 0; i < kMaxAcceptsPerPoll; ++i) {
    Descriptor socket = acceptFrom(listener_);
    if (!socket) return;
    if (connections_.size() == kMaxConnections) makeRoom();
    connections_.push_back({std::move(socket), now + kConnectionTime, {}, {}});
  }
}

// A scrape would otherwise wait for those who connect and say nothing.
void MetricsServer::makeRoom() {
  const auto idle =
      std::find_if(connections_.begin(), connections_.end(), [](const Connection& each) { return !each.answered; });
  connections_.erase(idle == connections_.end() ? connections_.begin() : idle);
}

void MetricsServer::serve(Connection& connection, TimePoint now, const std::function<std::string()>& text) {
  if (now > connection.end || !exchange(connection, text)) connection.socket = Descriptor();
}

// Returns false when the connection has ended. It is not closed right after the answer: what arrives at a closed socket
// would make the system discard the answer.
bool MetricsServer::exchange(Connection& connection, const std::function<std::string()>& text) {
  const Received received = receiveFrom(connection.socket);
  if (!connection.answered) {
    connection.request += received.bytes;
    if (const auto status = answerTo(connection.request, kPath)) {
      connection.response = httpResponse(*status, kContentType, *status == HttpStatus::kOk ? text() : "");
      connection.answered = true;
    }
  }
  if (!sendTo(connection.socket, connection.response)) return false;
  const bool sent = connection.answered && connection.response.empty();
  if (sent && !std::exchange(connection.finished, true)) finishSending(connection.socket);
  return !received.closed || (connection.answered && !sent);
}

}  // namespace platon
