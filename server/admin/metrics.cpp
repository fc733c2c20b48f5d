#include "server/admin/metrics.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <utility>

#include "protocol/program_error.h"
#include "server/admin/stream_socket.h"

namespace platon {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char byte : text) {
    if (byte == '\\' || byte == '"') result += '\\';
    if (byte == '\n')
      result += "\\n";
    else
      result += byte;
  }
  return result;
}

void append(std::string& text, std::string_view name, const MetricSample& sample) {
  text.append(name).append(sample.suffix);
  char separator = '{';
  for (const auto& [label, content] : sample.labels) {
    text.append(1, separator).append(label).append("=\"").append(escaped(content)).append("\"");
    separator = ',';
  }
  text.append(sample.labels.empty() ? " " : "} ").append(sample.value).append("\n");
}

}  // namespace

std::string secondsText(std::uint64_t microseconds) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%llu.%06llu", static_cast<unsigned long long>(microseconds / 1'000'000),
                static_cast<unsigned long long>(microseconds % 1'000'000));
  return text.data();
}

std::string formatMetrics(std::span<const Metric> metrics) {
  std::string text;
  for (const Metric& metric : metrics) {
    text.append("# HELP ").append(metric.name).append(" ").append(metric.help).append("\n");
    text.append("# TYPE ").append(metric.name).append(" ").append(metric.type).append("\n");
    for (const MetricSample& sample : metric.samples) append(text, metric.name, sample);
  }
  return text;
}

namespace {

std::string_view nameOf(HttpStatus status) {
  switch (status) {
    case HttpStatus::kOk:
      return "OK";
    case HttpStatus::kBadRequest:
      return "Bad Request";
    case HttpStatus::kNotFound:
      return "Not Found";
    case HttpStatus::kMethodNotAllowed:
      return "Method Not Allowed";
    case HttpStatus::kHeadTooLarge:
      return "Request Header Fields Too Large";
  }
  return "";
}

bool isMethod(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char byte) { return byte >= 'A' && byte <= 'Z'; });
}

bool isTarget(std::string_view word) {
  return word.starts_with('/') &&
         std::all_of(word.begin(), word.end(), [](char byte) { return byte > ' ' && byte < 127; });
}

}  // namespace

std::optional<HttpStatus> answerTo(std::string_view received, std::string_view path) {
  const std::size_t end = received.find("\r\n\r\n");
  if (std::min(end, received.size()) > kMaxHttpHeadBytes) return HttpStatus::kHeadTooLarge;
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = received.substr(0, received.find("\r\n"));
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) return HttpStatus::kBadRequest;
  const std::string_view method = line.substr(0, first);
  const std::string_view target = line.substr(first + 1, last - first - 1);
  const std::string_view version = line.substr(last + 1);
  const bool known = version == "HTTP/1.1" || version == "HTTP/1.0";
  if (!isMethod(method) || !isTarget(target) || !known) return HttpStatus::kBadRequest;
  if (target.substr(0, target.find('?')) != path) return HttpStatus::kNotFound;
  return method == "GET" ? HttpStatus::kOk : HttpStatus::kMethodNotAllowed;
}

std::string httpResponse(HttpStatus status, std::string_view contentType, std::string_view body) {
  const bool ok = status == HttpStatus::kOk;
  const std::string content = ok ? std::string(body) : std::string(nameOf(status)) + "\n";
  std::string response = "HTTP/1.1 " + std::to_string(static_cast<int>(status)) + " " + std::string(nameOf(status));
  if (status == HttpStatus::kMethodNotAllowed) response += "\r\nAllow: GET";
  response.append("\r\nContent-Type: ").append(ok ? contentType : "text/plain");
  response += "\r\nContent-Length: " + std::to_string(content.size()) + "\r\nConnection: close\r\n\r\n";
  return response + content;
}

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
