#include "client/lobby/name_lookup.h"

#include <atomic>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "protocol/transport/udp_socket.h"

namespace platon {

struct NameLookup::State {
  std::atomic<bool> stops = false;
  std::mutex mutex;
  std::vector<Answer> answers;  // that have not been taken

  void add(Answer answer) {
    const std::scoped_lock lock(mutex);
    answers.push_back(std::move(answer));
  }
};

namespace {

// An exception would end the program.
std::optional<IpAddress> resolvedAddress(const std::string& host, const NameLookup::Resolve& resolve) {
  try {
    return resolve(host);
  } catch (...) {
    return std::nullopt;
  }
}

}  // namespace

NameLookup::NameLookup(std::vector<std::string> hosts, const Resolve& resolve)
    : state_(std::make_shared<State>()), pending_(hosts.size()) {
  if (hosts.empty()) return;
  try {
    std::thread([state = state_, hosts, resolve] {
      for (const std::string& host : hosts) {
        if (state->stops) return;
        state->add({host, resolvedAddress(host, resolve)});
      }
    }).detach();
  } catch (const std::system_error&) {
    for (std::string& host : hosts) state_->add({std::move(host), std::nullopt});
  }
}

NameLookup::~NameLookup() { state_->stops = true; }

std::vector<NameLookup::Answer> NameLookup::take() {
  const std::scoped_lock lock(state_->mutex);
  pending_ -= state_->answers.size();
  return std::exchange(state_->answers, {});
}

std::optional<IpAddress> NameLookup::firstAddressOf(const std::string& host) {
  try {
    return resolve(host, 0).front().ip;
  } catch (const SocketError&) {
    return std::nullopt;
  }
}

}  // namespace platon
