#include <algorithm>
#include <optional>

#include "protocol/transport/sealed_channel.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/channel_model.h"
#include "tests/fuzz/enet_content.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

using Side = SealedChannel::Side;

constexpr std::uint16_t kSlot = 0x0102;
constexpr int kMaxChannelSteps = 200;

/// One direction of a session. The network repeats, reorders, drops and changes datagrams.
class Direction {
 public:
  explicit Direction(Side sender)
      : sender_(sender),
        model_(sender, sender == Side::kClient ? keys_.toServer : keys_.toClient, kSlot),
        sealer_(sender, keys_, kSlot),
        opener_(other(sender), keys_, kSlot) {}

  std::string step(ByteSource& bytes) {
    switch (bytes.below(6)) {
      case 0:
        return sealFault(bytes);
      case 1:
        return contentFault(bytes);
      case 2:
        return refusalFault(bytes);
      default:
        return arrivalFault(sequenceNear(bytes));
    }
  }

 private:
  static Side other(Side side) { return side == Side::kClient ? Side::kServer : Side::kClient; }

  // A number near one of the bounds of the receiver.
  std::uint64_t sequenceNear(ByteSource& bytes) const {
    constexpr std::int64_t kDistances[] = {0, static_cast<std::int64_t>(ReplayWindow::kSize), 1 << 13, 1 << 14,
                                           1 << 17};
    const std::int64_t distance = kDistances[bytes.below(std::size(kDistances))];
    const std::int64_t signedDistance = bytes.flag() ? -distance : distance;
    const std::int64_t offset = signedDistance + bytes.between(-8, 7);
    return static_cast<std::uint64_t>(std::max<std::int64_t>(0, static_cast<std::int64_t>(receiver_.next()) + offset));
  }

  // The real end seals what the model does.
  std::string sealFault(ByteSource& bytes) {
    const SealedChannel::Content content = model_.content(sealed_);
    if (sealer_.seal(content.bytes, content.isControl) != model_.datagram(sealed_))
      return "a datagram is sealed wrongly";
    const std::uint64_t sequence = sealed_++;
    return bytes.flag() ? arrivalFault(sequence) : std::string();
  }

  std::string arrivalFault(std::uint64_t sequence) {
    return openFault(sequence, model_.datagram(sequence), model_.content(sequence));
  }

  std::string openFault(std::uint64_t sequence, ByteSpan datagram, const SealedChannel::Content& content) {
    const bool expected = receiver_.accepts(sequence);
    const bool isNewest = receiver_.isNewest(sequence);
    const std::optional<SealedChannel::Content> opened = opener_.open(datagram);
    if (opened.has_value() != expected)
      return expected ? "a datagram is refused" : "a datagram is opened wrongly or twice";
    if (!opened) return {};
    receiver_.accept(sequence);
    if (opened->bytes != content.bytes || opened->isControl != content.isControl) return "a content has changed";
    return opened->isNewest == isNewest ? std::string() : "a datagram is wrongly held for the newest";
  }

  // What is opened is checked as ENet's before it is used.
  std::string contentFault(ByteSource& bytes) {
    const EnetSender sender = sender_ == Side::kClient ? EnetSender::kClient : EnetSender::kServer;
    const platon::Bytes content = enetContent(bytes, sender);
    const std::uint64_t sequence = receiver_.next();
    std::string fault = openFault(sequence, model_.seal(sequence, content, false), {content, false, false});
    return fault.empty() ? enetContentFault(content, sender) : fault;
  }

  // Changed datagrams have no effect: the unchanged one is opened afterwards, if it may be.
  std::string refusalFault(ByteSource& bytes) {
    const std::uint64_t sequence = sequenceNear(bytes);
    const platon::Bytes datagram = model_.datagram(sequence);
    const platon::Bytes changed = change(datagram, bytes);
    if (changed != datagram && opener_.open(changed)) return "a changed datagram is opened";
    if (sealer_.open(datagram)) return "a datagram is opened by its sender";
    return arrivalFault(sequence);
  }

  static platon::Bytes change(platon::Bytes datagram, ByteSource& bytes) {
    switch (bytes.below(4)) {
      case 0:
        datagram.resize(bytes.below(datagram.size()));
        break;
      case 1:
        datagram.push_back(bytes.byte());
        break;
      case 2:
        for (std::uint8_t& byte : datagram) byte ^= bytes.byte();
        break;
      default:
        datagram[bytes.below(datagram.size())] ^= bytes.byte();
    }
    return datagram;
  }

  SessionKeys keys_{CryptoKey{1}, CryptoKey{2}};
  Side sender_;
  ModelSender model_;
  ModelReceiver receiver_;
  SealedChannel sealer_;
  SealedChannel opener_;
  std::uint64_t sealed_ = 0;
};

}  // namespace

std::string channelFault(Bytes input) {
  ByteSource bytes(input);
  Direction direction(bytes.flag() ? Side::kClient : Side::kServer);
  std::string fault;
  for (int i = 0; i < kMaxChannelSteps && !bytes.empty() && fault.empty(); ++i) fault = direction.step(bytes);
  return fault;
}

}  // namespace platon::fuzz
