#pragma once

#include <memory>
#include <string>
#include <vector>

#include "protocol/program_error.h"
#include "protocol/transport/datagram_socket.h"

namespace platon {

/// A socket cannot be opened or a name cannot be resolved.
class SocketError : public ProgramError {
 public:
  explicit SocketError(const std::string& what, int exitCode = kFailed) : ProgramError(exitCode, what) {}
};

/// A UDP socket. Receives and sends several datagrams with one system call.
class UdpSocket : public DatagramSocket {
 public:
  /// Listens on an IPv4 or IPv6 address of this machine; "::" listens on all addresses of both kinds, and on all IPv4
  /// addresses where the machine has no IPv6. Port 0: any that is free. Throws SocketError: kFailed if another
  /// program uses the address, otherwise kUsage.
  UdpSocket(const std::string& bind, std::uint16_t port);
  /// A socket of a client: at a free port, for servers at addresses of both kinds. Throws SocketError.
  UdpSocket();
  ~UdpSocket() override;

  /// Lets `send` take addresses that all machines of a network receive.
  void allowBroadcast();

  std::optional<Datagram> receive(Time now) override;
  void send(const SocketAddress& receiver, ByteSpan bytes, Time now) override;
  void flush(Time now) override;
  void wait(std::chrono::milliseconds timeout) override;
  SocketAddress address() const override;

 private:
  struct Batches;

  void open(bool ipv6);
  bool bindTo(const SocketAddress& own) const;

  int handle_ = -1;
  bool ipv6_ = false;
  std::unique_ptr<Batches> batches_;
};

/// The addresses of a host name, or of an address in text form, in the order in which they should be tried. Throws
/// SocketError if there is none.
std::vector<SocketAddress> resolve(const std::string& host, std::uint16_t port);

}  // namespace platon
