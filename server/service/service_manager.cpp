#include "server/service/service_manager.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace platon {
namespace {

// 0 unless the text is a number.
std::int64_t numberOf(const char* text) {
  if (text == nullptr) return 0;
  const char* const end = text + std::strlen(text);
  std::int64_t number = 0;
  const auto [rest, error] = std::from_chars(text, end, number);
  return error == std::errc() && rest == end && number > 0 ? number : 0;
}

// The bytes of the address, or none if it is not one.
std::string addressOf(const char* socket) {
  std::string address = socket == nullptr ? "" : socket;
  const bool known = address.starts_with('/') || address.starts_with('@');
  if (!known || address.size() < 2 || address.size() >= sizeof(sockaddr_un::sun_path)) return "";
  if (address.front() == '@') address.front() = '\0';
  return address;
}

}  // namespace

ServiceManager::Environment ServiceManager::Environment::current() {
  return {std::getenv("NOTIFY_SOCKET"), std::getenv("WATCHDOG_USEC"), std::getenv("WATCHDOG_PID"), getpid()};
}

ServiceManager::ServiceManager(const Environment& environment) : address_(addressOf(environment.socket)) {
  if (address_.empty()) return;
  socket_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const bool ours =
      environment.watchdogProcess == nullptr || numberOf(environment.watchdogProcess) == environment.process;
  if (ours) interval_ = std::chrono::microseconds(numberOf(environment.watchdogMicroseconds) / 2);
}

void ServiceManager::ready() { tell("READY=1"); }

void ServiceManager::reloading(TimePoint now) {
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(now.time_since_epoch());
  tell("RELOADING=1\nMONOTONIC_USEC=" + std::to_string(since.count()));
}

void ServiceManager::stopping() { tell("STOPPING=1"); }

void ServiceManager::alive(TimePoint now, bool draining) {
  if (!watched() || now < nextSign_) return;
  nextSign_ = now + interval_;
  constexpr auto kMore = std::chrono::microseconds(kStopTime).count();
  tell("WATCHDOG=1" + (draining ? "\nEXTEND_TIMEOUT_USEC=" + std::to_string(kMore) : ""));
}

void ServiceManager::tell(std::string_view message) const {
  if (!socket_) return;
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  std::memcpy(to.sun_path, address_.data(), address_.size());
  // A path ends with a zero byte; an abstract name has as many bytes as its length says.
  const std::size_t length = offsetof(sockaddr_un, sun_path) + address_.size() + (address_.front() == '\0' ? 0 : 1);
  sendto(socket_.number(), message.data(), message.size(), MSG_NOSIGNAL, reinterpret_cast<const sockaddr*>(&to),
         static_cast<socklen_t>(length));
}

}  // namespace platon
