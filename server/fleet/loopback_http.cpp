#include "server/fleet/loopback_http.h"

#include <cerrno>
#include <cstring>

#include "server/admin/stream_socket.h"
#include "server/fleet/agones_call.h"

namespace platon {
namespace {

constexpr int kOk = 200;
constexpr std::size_t kMaxHeadBytes = 8 * 1024;

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

}  // namespace

std::optional<std::string> sendOverLoopback(std::string request, std::uint16_t port, std::chrono::milliseconds limit,
                                            const std::function<TimePoint()>& clock) {
  const TimeLeft left(limit, clock);
  const Descriptor socket = connectTo(port, left);
  if (!socket) return std::strerror(errno);
  std::string received;
  while (left().count() > 0) {
    if (!sendTo(socket, request)) return "the connection broke";
    if (!waitFor(socket, !request.empty(), left())) break;
    const Received part = receiveFrom(socket);
    received += part.bytes;
    if (const auto status = statusOf(received)) {
      return *status == kOk ? std::nullopt : std::optional("it answers with HTTP status " + std::to_string(*status));
    }
    if (part.closed || received.size() > kMaxHeadBytes) return "it closed the connection without an answer";
  }
  return "it does not answer in time";
}

}  // namespace platon
