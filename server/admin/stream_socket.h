#pragma once

#include <chrono>
#include <string>

#include "protocol/files/descriptor.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// Connects to the Unix socket of a running server. The descriptor is empty if nobody listens at the path; errno then
/// holds the reason.
Descriptor connectUnix(const std::string& path);
/// The user who runs the program at the other end of a Unix socket is this user or root.
bool peerIsTrusted(const Descriptor& socket);
/// The user who listens at the path of a Unix socket, to which `socket` is connected, is this user or root. For root it
/// may also be the user who owns the folder of the socket, if nobody else can write there: root has servers of other
/// users to control, and anybody can put a socket into a folder like /tmp.
bool listenerIsTrusted(const Descriptor& socket, const std::string& path);

/// Connects to a TCP address, and waits for at most `limit`. The descriptor is empty on failure; errno then holds the
/// reason.
Descriptor connectTcp(const SocketAddress& address, std::chrono::milliseconds limit);
/// Waits until bytes have arrived, or with `sends` until the system takes some, for at most `limit`. Returns whether
/// that has happened; a broken connection counts.
bool waitFor(const Descriptor& socket, bool sends, std::chrono::milliseconds limit);

/// Listens at a TCP address; port 0: any that is free. The descriptor is empty on failure; errno then holds the reason.
Descriptor listenTcp(const SocketAddress& address);
/// Port of a listening TCP socket.
std::uint16_t portOf(const Descriptor& listener);

/// The next connection, which does not block; empty if there is none.
Descriptor acceptFrom(const Descriptor& listener);

/// What has arrived at a stream socket.
struct Received {
  std::string bytes;    ///< at most kMaxReceivedBytes
  bool closed = false;  ///< the other end has closed the connection, or it is broken
};
inline constexpr std::size_t kMaxReceivedBytes = 4096;

/// Receives what has arrived; does not wait.
Received receiveFrom(const Descriptor& socket);
/// Sends as many of the bytes as the system takes and removes them; does not wait. Returns false if the connection is
/// broken.
bool sendTo(const Descriptor& socket, std::string& bytes);
/// Tells the other end that nothing more follows.
void finishSending(const Descriptor& socket);

}  // namespace platon
