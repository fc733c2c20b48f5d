#include "server/admin/console_server.h"

#include <algorithm>
#include <utility>

#include "server/admin/console_command.h"
#include "server/admin/stream_socket.h"

namespace platon {

void ConsoleServer::poll(TimePoint now, const Execute& execute) {
  accept(now);
  for (Console& console : consoles_) serve(console, now, execute);
  std::erase_if(consoles_, [](const Console& console) { return !console.socket; });
}

// At most one in each call, so that programs that connect again and again cannot hold up the server.
void ConsoleServer::accept(TimePoint now) {
  Descriptor socket = acceptFrom(socket_.listener());
  if (!socket || !peerIsTrusted(socket)) return;
  if (consoles_.size() == kMaxConsoles) {
    consoles_.erase(std::min_element(consoles_.begin(), consoles_.end(),
                                     [](const Console& a, const Console& b) { return a.activeAt < b.activeAt; }));
  }
  consoles_.push_back({std::move(socket), LineBuffer(kMaxConsoleLineBytes), {}, now});
}

// Nothing is read while a command or a reply waits, so that the memory of a console is bounded.
void ConsoleServer::serve(Console& console, TimePoint now, const Execute& execute) {
  if (console.output.empty() && !console.lines.ready()) receive(console, now);
  if (console.output.empty()) executeNext(console, now, execute);
  const std::size_t before = console.output.size();
  const bool broken = !sendTo(console.socket, console.output);
  if (console.output.size() < before) console.activeAt = now;
  const bool stuck = !console.output.empty() && now - console.activeAt > kReadTime;
  const bool done = console.closing && console.output.empty() && !console.lines.ready();
  if (broken || stuck || done) console.socket = Descriptor();
}

void ConsoleServer::executeNext(Console& console, TimePoint now, const Execute& execute) {
  if (const auto line = console.lines.next()) {
    console.output = encode(execute(*line));
    console.activeAt = now;
  } else if (console.lines.tooLong()) {
    console.output = encode(ConsoleReply{
        false, "a command has at most " + std::to_string(kMaxConsoleLineBytes) + " bytes; the console is closed"});
    console.closing = true;
    console.lines = LineBuffer(kMaxConsoleLineBytes);
  }
}

void ConsoleServer::receive(Console& console, TimePoint now) {
  Received received = receiveFrom(console.socket);
  if (!received.bytes.empty()) console.activeAt = now;
  console.lines.add(received.bytes);
  console.closing = console.closing || received.closed;
}

}  // namespace platon
