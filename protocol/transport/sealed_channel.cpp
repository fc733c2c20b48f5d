#include "protocol/transport/sealed_channel.h"

#include "protocol/transport/noise.h"

namespace platon {
namespace {

constexpr std::uint8_t kSealedFlag = 0x80;
constexpr std::uint8_t kControlFlag = 0x40;
constexpr std::uint64_t kSequenceSpan = 1 << 14;  // numbers that the bits on the wire tell apart

}  // namespace

bool ReplayWindow::isFresh(std::uint64_t sequence) const {
  if (sequence >= next_) return true;
  return next_ - sequence <= kSize && !arrived_[sequence % kSize];
}

void ReplayWindow::mark(std::uint64_t sequence) {
  if (sequence >= next_ + kSize) arrived_.reset();
  while (next_ <= sequence && next_ + kSize > sequence) arrived_[next_++ % kSize] = false;
  next_ = std::max(next_, sequence + 1);
  arrived_[sequence % kSize] = true;
}

SealedChannel::SealedChannel(Side side, const SessionKeys& keys, std::uint16_t slot)
    : side_(side), keys_(keys), slot_(slot) {}

Bytes SealedChannel::seal(ByteSpan content, bool isControl) {
  const std::size_t head = headBytes(side_);
  Bytes datagram(head + content.size() + kTagBytes);
  const std::uint64_t low = sent_ % kSequenceSpan;
  datagram[0] = static_cast<std::uint8_t>(kSealedFlag | (isControl ? kControlFlag : 0) | low >> 8);
  datagram[1] = static_cast<std::uint8_t>(low);
  if (side_ == Side::kClient) {
    datagram[2] = static_cast<std::uint8_t>(slot_);
    datagram[3] = static_cast<std::uint8_t>(slot_ >> 8);
  }
  const std::span<std::uint8_t> bytes(datagram);
  sealWith(sendKey(), sent_++, bytes.first(head), content, bytes.subspan(head));
  return datagram;
}

// The number with these low bits that is nearest to the next one expected; of two that are equally near, the higher.
std::uint64_t SealedChannel::expand(std::uint16_t low) const {
  const std::uint64_t expected = received_.next();
  std::uint64_t sequence = expected - expected % kSequenceSpan + low;
  if (sequence + kSequenceSpan / 2 <= expected) sequence += kSequenceSpan;
  if (sequence > expected + kSequenceSpan / 2 && sequence >= kSequenceSpan) sequence -= kSequenceSpan;
  return sequence;
}

std::optional<SealedChannel::Content> SealedChannel::open(ByteSpan datagram) {
  const std::size_t head = headBytes(side_ == Side::kServer ? Side::kClient : Side::kServer);
  if (!isSealed(datagram) || datagram.size() < head + kTagBytes) return std::nullopt;
  const auto low = static_cast<std::uint16_t>((datagram[0] & (kControlFlag - 1)) << 8 | datagram[1]);
  const std::uint64_t sequence = expand(low);
  if (!received_.isFresh(sequence)) return std::nullopt;
  Content content;
  content.bytes.resize(datagram.size() - head - kTagBytes);
  if (!openWith(receiveKey(), sequence, datagram.first(head), datagram.subspan(head), content.bytes))
    return std::nullopt;
  content.isControl = (datagram[0] & kControlFlag) != 0;
  content.isNewest = sequence >= received_.next();
  received_.mark(sequence);
  return content;
}

bool SealedChannel::isSealed(ByteSpan datagram) { return !datagram.empty() && (datagram[0] & kSealedFlag) != 0; }

std::optional<std::uint16_t> SealedChannel::slotOf(ByteSpan datagram) {
  if (!isSealed(datagram) || datagram.size() < 4 + kTagBytes) return std::nullopt;
  return static_cast<std::uint16_t>(datagram[2] | datagram[3] << 8);
}

}  // namespace platon
