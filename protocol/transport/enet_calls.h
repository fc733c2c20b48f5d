#pragma once

#include <enet/enet.h>

#include <optional>

#include "protocol/moment.h"
#include "protocol/transport/noise.h"

namespace platon {

/// What ENet sends to and receives from instead of a socket: the contents of sealed datagrams. ENet's address of a
/// session has the session's number as host and its slot as port.
class EnetPort {
 public:
  EnetPort() = default;
  virtual ~EnetPort() = default;
  EnetPort(const EnetPort&) = delete;
  EnetPort& operator=(const EnetPort&) = delete;

  virtual void sendFromEnet(const ENetAddress& session, ByteSpan bytes) = 0;

  struct Received {
    ENetAddress session;
    ByteSpan bytes;  ///< not empty, at most ENET_PROTOCOL_MAXIMUM_MTU; valid until the next call
  };
  virtual std::optional<Received> receiveForEnet() = 0;
};

/// While it exists, ENet uses this port and this time in this thread. Every call of ENet that sends, receives or reads
/// the time happens inside one. libenet calls enet_socket_send, enet_socket_receive and enet_time_get through the
/// dynamic linker, which takes the definitions beside this class instead of those of the library.
class EnetScope {
 public:
  EnetScope(EnetPort& port, Moment now);
  ~EnetScope();
  EnetScope(const EnetScope&) = delete;
  EnetScope& operator=(const EnetScope&) = delete;

 private:
  EnetPort* outer_;
  enet_uint32 outerTime_;
};

/// Whether libenet really calls the functions of this program. False if it was linked in a way that hides them; nothing
/// would then be sealed, so the programs must not start.
bool enetUsesOurCalls();

}  // namespace platon
