#include "tests/net/support/datagram_network.h"

namespace platon {

class DatagramNetwork::Socket : public DatagramSocket {
 public:
  Socket(DatagramNetwork& network, const SocketAddress& own) : network_(network), own_(own) {}

  std::optional<Datagram> receive(Time) override {
    std::deque<Waiting>& waiting = network_.waiting_[own_];
    if (waiting.empty()) return std::nullopt;
    current_ = std::move(waiting.front());
    waiting.pop_front();
    return Datagram{current_.from, current_.bytes};
  }

  void send(const SocketAddress& receiver, ByteSpan bytes, Time) override {
    network_.sent_.push_back({own_, receiver, {bytes.begin(), bytes.end()}});
    if (!network_.filter_ || network_.filter_(network_.sent_.back())) network_.inject(own_, receiver, bytes);
  }

  void flush(Time) override {}
  void wait(std::chrono::milliseconds) override {}
  SocketAddress address() const override { return own_; }

 private:
  DatagramNetwork& network_;
  SocketAddress own_;
  Waiting current_;
};

std::unique_ptr<DatagramSocket> DatagramNetwork::socket(const SocketAddress& own) {
  return std::make_unique<Socket>(*this, own);
}

void DatagramNetwork::inject(const SocketAddress& from, const SocketAddress& to, ByteSpan bytes) {
  waiting_[to].push_back({from, {bytes.begin(), bytes.end()}});
}

std::size_t DatagramNetwork::bytesTo(const SocketAddress& receiver) const {
  std::size_t bytes = 0;
  for (const Sent& sent : sent_) bytes += sent.to == receiver ? sent.bytes.size() : 0;
  return bytes;
}

SocketAddress addressAt(std::string_view ip, std::uint16_t port) { return {IpAddress::parse(ip).value(), port}; }

}  // namespace platon
