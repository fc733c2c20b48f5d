#include "tests/fuzz/channel_model.h"

#include <algorithm>

#include "protocol/transport/noise.h"

namespace platon::fuzz {
namespace {

constexpr std::uint64_t kSpan = 1 << 14;  // numbers that the sent bits tell apart
constexpr std::uint64_t kWindow = 512;
constexpr std::uint64_t kSizes = 37;

}  // namespace

ModelSender::ModelSender(SealedChannel::Side side, const CryptoKey& key, std::uint16_t slot)
    : side_(side), key_(key), slot_(slot) {}

SealedChannel::Content ModelSender::content(std::uint64_t sequence) const {
  SealedChannel::Content content;
  content.bytes.resize(sequence % kSizes);
  for (std::size_t i = 0; i < content.bytes.size(); ++i) {
    content.bytes[i] = static_cast<std::uint8_t>((sequence + i) * 0x9e3779b97f4a7c15 >> 56);
  }
  content.isControl = sequence % 5 == 0;
  return content;
}

platon::Bytes ModelSender::datagram(std::uint64_t sequence) const {
  const SealedChannel::Content sent = content(sequence);
  return seal(sequence, sent.bytes, sent.isControl);
}

platon::Bytes ModelSender::seal(std::uint64_t sequence, ByteSpan content, bool isControl) const {
  const auto head = static_cast<std::uint16_t>(0x8000 | (isControl ? 0x4000 : 0) | sequence % kSpan);
  platon::Bytes datagram{static_cast<std::uint8_t>(head >> 8), static_cast<std::uint8_t>(head)};
  if (side_ == SealedChannel::Side::kClient) {
    datagram.push_back(static_cast<std::uint8_t>(slot_));
    datagram.push_back(static_cast<std::uint8_t>(slot_ >> 8));
  }
  platon::Bytes sealed(content.size() + kTagBytes);
  sealWith(key_, sequence, datagram, content, sealed);
  datagram.insert(datagram.end(), sealed.begin(), sealed.end());
  return datagram;
}

bool ModelReceiver::accepts(std::uint64_t sequence) const {
  if (sequence >= next_) return sequence < kSpan || sequence - next_ <= kSpan / 2;
  return next_ - sequence <= kWindow && !accepted_.contains(sequence);
}

void ModelReceiver::accept(std::uint64_t sequence) {
  accepted_.insert(sequence);
  next_ = std::max(next_, sequence + 1);
}

}  // namespace platon::fuzz
