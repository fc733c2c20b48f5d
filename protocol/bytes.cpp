#include "protocol/bytes.h"

namespace platon {

std::uint8_t ByteReader::byte() {
  if (remaining_.empty()) {
    ok_ = false;
    return 0;
  }
  const std::uint8_t value = remaining_.front();
  remaining_ = remaining_.subspan(1);
  return value;
}

std::uint32_t ByteReader::fixed32() {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 32; shift += 8) value |= std::uint32_t{byte()} << shift;
  return ok_ ? value : 0;
}

std::uint32_t ByteReader::varint() {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 35; shift += 7) {
    const std::uint8_t next = byte();
    const bool overflows = shift == 28 && next > 0x0f;
    const bool tooLong = shift > 0 && next == 0;
    if (!ok_ || overflows || tooLong) break;
    value |= std::uint32_t{next & 0x7fu} << shift;
    if (next < 0x80) return value;
  }
  ok_ = false;
  return 0;
}

void ByteWriter::fixed32(std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) byte(static_cast<std::uint8_t>(value >> shift));
}

void ByteWriter::varint(std::uint32_t value) {
  for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
  byte(static_cast<std::uint8_t>(value));
}

}  // namespace platon
