#include "tests/server/fleet/fake_sidecar.h"

#include <algorithm>
#include <regex>
#include <stdexcept>

#include "server/admin/stream_socket.h"

namespace platon {
namespace {

Descriptor listenAt(std::uint16_t port) { return listenTcp({*IpAddress::parse("127.0.0.1"), port}); }

std::string responseOf(const std::string& status, const std::string& body) {
  return "HTTP/1.1 " + status + "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
         "\r\nConnection: close\r\n\r\n" + body;
}

// An answer to HTTP/1.0 has no length: it ends with the connection.
std::string lastResponseOf(const std::string& body) {
  return "HTTP/1.0 200 OK\r\nContent-Type: application/json\r\n\r\n" + body;
}

// The whole request, head and body, once it has arrived; empty before.
std::string wholeRequest(const std::string& received) {
  const std::size_t head = received.find("\r\n\r\n");
  std::smatch found;
  const bool has = std::regex_search(received, found, std::regex("\r\nContent-Length: ([0-9]+)\r\n"));
  if (head == std::string::npos) return "";
  const std::size_t size = head + 4 + (has ? std::stoul(found[1]) : 0);
  return received.size() >= size ? received.substr(0, size) : "";
}

}  // namespace

FakeSidecar::FakeSidecar() : listener_(listenAt(0)) {
  if (!listener_) throw std::runtime_error("cannot listen on 127.0.0.1");
  port_ = portOf(listener_);
  thread_ = std::thread([this] { run(); });
}

FakeSidecar::~FakeSidecar() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  thread_.join();
}

void FakeSidecar::set(Mode mode) {
  const std::lock_guard lock(mutex_);
  mode_ = mode;
}

void FakeSidecar::vanish() {
  const std::lock_guard lock(mutex_);
  listener_ = Descriptor();
  connections_.clear();
}

void FakeSidecar::comeBack() {
  const std::lock_guard lock(mutex_);
  listener_ = listenAt(port_);
  if (!listener_) throw std::runtime_error("cannot listen on the same port again");
}

void FakeSidecar::allocate() {
  const std::lock_guard lock(mutex_);
  setState("Allocated");
  players_ = std::min(players_ + 1, places_);
}

std::vector<std::string> FakeSidecar::calls() {
  const std::lock_guard lock(mutex_);
  return calls_;
}

std::size_t FakeSidecar::count(const std::string& call) {
  const std::vector<std::string> all = calls();
  return static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [&](const std::string& one) { return one.starts_with(call); }));
}

std::size_t FakeSidecar::requests() {
  const std::lock_guard lock(mutex_);
  return requests_;
}

std::size_t FakeSidecar::unanswered() {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  std::size_t newest = 0;
  for (const Connection& connection : connections_) {
    const bool waits = connection.isSilent || now < connection.answerAt;
    if (waits) newest = std::max(newest, connection.request);
  }
  return newest;
}

std::vector<std::string> FakeSidecar::faults() {
  const std::lock_guard lock(mutex_);
  return faults_;
}

void FakeSidecar::run() {
  for (;; std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    const std::lock_guard lock(mutex_);
    if (ended_) return;
    if (listener_) {
      if (Descriptor socket = acceptFrom(listener_)) connections_.push_back({.socket = std::move(socket)});
    }
    for (Connection& connection : connections_) serve(connection);
    std::erase_if(connections_, [](const Connection& connection) { return !connection.socket; });
  }
}

void FakeSidecar::serve(Connection& connection) {
  const auto now = std::chrono::steady_clock::now();
  const Received part = receiveFrom(connection.socket);
  connection.received += part.bytes;
  const std::string request = wholeRequest(connection.received);
  if (!connection.answered && !request.empty()) {
    connection.answered = true;
    connection.answerAt = now + (mode_ == Mode::kIsLate ? kLateness : std::chrono::milliseconds(0));
    connection.response = answer(request);
    connection.request = requests_;
    connection.isSilent = mode_ == Mode::kIsSilent;
  }
  const bool breaks = now >= connection.answerAt && !sendTo(connection.socket, connection.response);
  const bool isSent = connection.answered && !connection.isSilent && connection.response.empty();
  if (part.closed || breaks || isSent) connection.socket = Descriptor();
}

std::string FakeSidecar::answer(const std::string& request) {
  ++requests_;
  if (mode_ == Mode::kRefuses) return responseOf("500 Internal Server Error", R"({"code":2,"message":"refused"})");
  if (mode_ == Mode::kIsSilent) return "";
  try {
    return take(SidecarRequest::read(request));
  } catch (const std::logic_error& fault) {  // also of std::map and std::stoll
    faults_.emplace_back(fault.what());
    return responseOf("400 Bad Request", R"({"code":3,"message":"bad request"})");
  }
}

// Does what a request asks for. There is no counter other than that of players.
std::string FakeSidecar::take(const SidecarRequest& request) {
  std::string answered = "{}";
  if (request.method == "PATCH") answered = takePlayers(request);
  if (request.path == "/ready") setState("Ready");
  if (request.path == "/allocate") setState("Allocated");
  calls_.push_back(request.method + " " + request.path + " " + request.text);
  return request.method == "GET" ? lastResponseOf(gameServer()) : responseOf("200 OK", answered);
}

// A counter cannot hold more than its capacity.
std::string FakeSidecar::takePlayers(const SidecarRequest& request) {
  if (request.path != "/v1beta1/counters/players") throw std::invalid_argument("there is no counter " + request.path);
  const std::string count = request.body.at("count");
  const std::string capacity = request.body.at("capacity");
  if (std::stoll(count) < 0 || std::stoll(count) > std::stoll(capacity))
    throw std::invalid_argument(count + " players are out of range");
  players_ = std::stoll(count);
  places_ = std::stoll(capacity);
  return R"({"name":"players","count":")" + count + R"(","capacity":")" + capacity + "\"}";
}

// A game server that becomes allocated gets the time of that.
void FakeSidecar::setState(const std::string& state) {
  state_ = state;
  if (state == "Allocated") ++allocations_;
}

// All properties are there, numbers of 64 bits as texts, as the gateway of Agones writes them.
std::string FakeSidecar::gameServer() const {
  const std::string allocated = "2026-11-27T18:00:00." + std::to_string(allocations_) + "Z";
  const std::string annotation = allocations_ > 0 ? R"("agones.dev/last-allocated": ")" + allocated + R"(", )" : "";
  return R"({"object_meta": {"name": "platon-1", "namespace": "default", "uid": "1", "resource_version": "7", )"
         R"("generation": "3", "creation_timestamp": "1764266400", "deletion_timestamp": "0", "annotations": {)" +
         annotation + R"("agones.dev/sdk-version": "1.57.0"}, "labels": {"agones.dev/fleet": "platon"}}, "spec": )" +
         R"({"health": {"disabled": false, "period_seconds": 5, "failure_threshold": 3, "initial_delay_seconds": 5}}, )" +
         R"("status": {"state": ")" + state_ +
         R"(", "address": "192.0.2.1", "addresses": [], "ports": [{"name": "game", )" +
         R"("port": 7000}], "players": null, "counters": {"players": {"count": ")" + std::to_string(players_) +
         R"(", "capacity": ")" + std::to_string(places_) + R"("}}, "lists": {}}})";
}

}  // namespace platon
