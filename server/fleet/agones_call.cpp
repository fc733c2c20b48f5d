#include "server/fleet/agones_call.h"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

namespace platon {
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

}  // namespace platon
