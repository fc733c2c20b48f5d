#include "server/fleet/loopback_http.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include "server/admin/stream_socket.h"
#include "server/fleet/agones_call.h"

namespace platon {
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
