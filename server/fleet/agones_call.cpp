#include "server/fleet/agones_call.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "protocol/program_error.h"
#include "server/admin/stream_socket.h"

namespace platon {

std::optional<std::uint16_t> agonesPortOf(const char* value) {
  const std::string_view text = value == nullptr ? "" : value;
  if (text.empty()) return std::nullopt;
  std::uint16_t port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  if (error == std::errc() && end == text.data() + text.size() && port != 0) return port;
  throw ProgramError(ProgramError::kUsage, std::string(kAgonesPortVariable) + " must be a port from 1 to 65535, not '" +
                                               std::string(text) + "'; unset it to run without Agones");
}

namespace {

// Longest first line of a response, bytes; a sidecar sends far less.
constexpr std::size_t kMaxStatusLineBytes = 512;

std::string_view pathOf(AgonesCall call) {
  switch (call) {
    case AgonesCall::kReady:
      return "/ready";
    case AgonesCall::kHealth:
      return "/health";
    case AgonesCall::kAllocate:
      return "/allocate";
    case AgonesCall::kPlayers:
      return "/v1beta1/counters/players";
    case AgonesCall::kGameServer:
      return "/gameserver";
    case AgonesCall::kShutdown:
      return "/shutdown";
  }
  return "";
}

// Numbers of 64 bits are texts in the JSON of protocol buffers.
std::string bodyOf(AgonesCall call, const PlayerCount& count) {
  if (call != AgonesCall::kPlayers) return "{}";
  return nlohmann::ordered_json{{"count", std::to_string(count.players)}, {"capacity", std::to_string(count.limit)}}
      .dump();
}

}  // namespace

std::string_view nameOf(AgonesCall call) {
  const std::string_view path = pathOf(call);
  return path.substr(path.rfind('/') + 1);
}

// An answer to HTTP/1.0 ends where the connection does, and never comes in chunks.
std::string agonesRequest(AgonesCall call, std::uint16_t port, const PlayerCount& count) {
  const std::string host = "Host: localhost:" + std::to_string(port) + "\r\n";
  if (call == AgonesCall::kGameServer)
    return std::string("GET ").append(pathOf(call)) + " HTTP/1.0\r\n" + host + "\r\n";
  const std::string body = bodyOf(call, count);
  std::string request(call == AgonesCall::kPlayers ? "PATCH " : "POST ");
  request.append(pathOf(call)).append(" HTTP/1.1\r\n").append(host);
  request.append("Content-Type: application/json\r\nContent-Length: ").append(std::to_string(body.size()));
  return request.append("\r\nConnection: close\r\n\r\n").append(body);
}

std::optional<std::string> lastAllocation(std::string_view body) {
  const auto server = nlohmann::json::parse(body, nullptr, false);
  const auto meta = server.is_object() ? server.find("object_meta") : server.end();
  if (meta == server.end() || !meta->is_object()) return std::nullopt;
  const auto annotations = meta->find("annotations");
  if (annotations == meta->end() || !annotations->is_object()) return "";
  const auto allocation = annotations->find("agones.dev/last-allocated");
  if (allocation == annotations->end()) return "";
  return allocation->is_string() ? std::optional(allocation->get<std::string>()) : std::nullopt;
}

std::optional<int> statusOf(std::string_view received) {
  const std::size_t end = received.find("\r\n");
  if (end == std::string_view::npos) return received.size() > kMaxStatusLineBytes ? std::optional(0) : std::nullopt;
  const std::string_view line = received.substr(0, end);
  if (!line.starts_with("HTTP/1.1 ") && !line.starts_with("HTTP/1.0 ")) return 0;
  const std::string_view digits = line.substr(9, 3);
  const bool ends = line.size() == 12 || (line.size() > 12 && line[12] == ' ');
  int status = 0;
  const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), status);
  const bool whole = error == std::errc() && rest == digits.data() + digits.size() && ends;
  return whole && status >= 100 ? status : 0;
}

namespace {

constexpr int kOk = 200;
constexpr std::size_t kMaxAnswerBytes = 1024 * 1024;

// Time left until an end; none is left when it has passed.
class TimeLeft {
 public:
  TimeLeft(std::chrono::milliseconds limit, const std::function<TimePoint()>& clock)
      : clock_(clock), end_(clock() + limit) {}

  std::chrono::milliseconds operator()() const {
    return std::max(std::chrono::ceil<std::chrono::milliseconds>(end_ - clock_()), std::chrono::milliseconds(0));
  }

 private:
  const std::function<TimePoint()>& clock_;
  TimePoint end_;
};

// After a failure errno is that of IPv4: a machine without IPv6 would have another reason.
Descriptor connectTo(std::uint16_t port, const TimeLeft& left) {
  Descriptor socket = connectTcp({*IpAddress::parse("127.0.0.1"), port}, left());
  if (socket) return socket;
  const int fault = errno;
  socket = connectTcp({*IpAddress::parse("::1"), port}, left());
  errno = fault;
  return socket;
}

LoopbackAnswer faulty(std::string fault) { return {std::move(fault)}; }

// What follows the head of an answer; nothing if the head is incomplete.
std::string afterHead(const std::string& answer) {
  const std::size_t end = answer.find("\r\n\r\n");
  return end == std::string::npos ? "" : answer.substr(end + 4);
}

}  // namespace

LoopbackAnswer sendOverLoopback(std::string request, std::uint16_t port, LoopbackPart part,
                                std::chrono::milliseconds limit, const std::function<TimePoint()>& clock) {
  const TimeLeft left(limit, clock);
  const Descriptor socket = connectTo(port, left);
  if (!socket) return faulty(std::strerror(errno));
  std::string received;
  while (left().count() > 0) {
    if (!sendTo(socket, request)) return faulty("the connection broke");
    if (!waitFor(socket, !request.empty(), left())) break;
    const Received more = receiveFrom(socket);
    received += more.bytes;
    const std::optional<int> status = statusOf(received);
    if (status && *status != kOk) return faulty("it answers with HTTP status " + std::to_string(*status));
    if (status && (more.closed || part == LoopbackPart::kStatus)) return {{}, afterHead(received)};
    if (more.closed) return faulty("it closed the connection without an answer");
    if (received.size() > kMaxAnswerBytes) return faulty("its answer is longer than 1 MiB");
  }
  return faulty("it does not answer in time");
}

}  // namespace platon
