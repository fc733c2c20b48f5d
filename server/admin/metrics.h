#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "protocol/files/descriptor.h"
#include "protocol/transport/socket_address.h"
#include "server/base/time_point.h"

namespace platon {

/// A value of a metric.
struct MetricSample {
  std::string value;                                             ///< a number that is not negative
  std::vector<std::pair<std::string_view, std::string>> labels;  ///< names and values, in UTF-8
  std::string_view suffix;                                       ///< of the name: "_sum" or "_count" of a summary
};

/// What a server reports under one name.
struct Metric {
  std::string_view name;
  std::string_view type;  ///< "counter", which ends with _total and counts since the start, "gauge" or "summary"
  std::string_view help;  ///< a sentence without \ and line feeds
  std::vector<MetricSample> samples;
};

/// A time in microseconds as a decimal number of seconds, exactly.
std::string secondsText(std::uint64_t microseconds);

/// The metrics in the text format of Prometheus, version 0.0.4.
std::string formatMetrics(std::span<const Metric> metrics);

/// Longest head of a request, bytes.
inline constexpr std::size_t kMaxHttpHeadBytes = 8 * 1024;

enum class HttpStatus {
  kOk = 200,
  kBadRequest = 400,
  kNotFound = 404,
  kMethodNotAllowed = 405,
  kHeadTooLarge = 431,
};

/// The status with which a server that has the one page `path`, for GET alone, answers a request of HTTP/1.0 or
/// HTTP/1.1. `received`: all that has arrived so far. Nothing as long as the head of the request is incomplete.
std::optional<HttpStatus> answerTo(std::string_view received, std::string_view path);

/// A complete response, after which the connection closes. `body`: of kOk; the others have one that names the status.
std::string httpResponse(HttpStatus status, std::string_view contentType, std::string_view body);

/// Reads `192.0.2.1:19777` or `[2001:db8::1]:19777`; port 0 … 65535. Nothing if the text is no such address.
std::optional<SocketAddress> parseSocketAddress(std::string_view text);

/// Answers `GET /metrics` over HTTP. Never waits.
class MetricsServer {
 public:
  /// Most connections at a time. For another one, the oldest of those that have not asked yet ends, or else the oldest.
  static constexpr std::size_t kMaxConnections = 16;
  /// Time in which a connection must send its request and read the answer.
  static constexpr std::chrono::seconds kConnectionTime{5};

  /// Listens; port 0: any that is free. Throws ProgramError: kFailed if another program uses the address, otherwise
  /// kUsage.
  explicit MetricsServer(const SocketAddress& address);

  /// Accepts connections, and receives and sends what they take. `text` makes the page, once for each request.
  void poll(TimePoint now, const std::function<std::string()>& text);

  /// Where it listens.
  SocketAddress address() const { return address_; }
  std::size_t connections() const { return connections_.size(); }

 private:
  struct Connection {
    Descriptor socket;
    TimePoint end;         // when it is dropped
    std::string request;   // received so far
    std::string response;  // to send
    bool answered = false;
    bool finished = false;  // all is sent; waits for the other end to close
  };

  void accept(TimePoint now);
  void makeRoom();
  static void serve(Connection& connection, TimePoint now, const std::function<std::string()>& text);
  static bool exchange(Connection& connection, const std::function<std::string()>& text);

  SocketAddress address_;
  Descriptor listener_;
  std::vector<Connection> connections_;
};

}  // namespace platon
