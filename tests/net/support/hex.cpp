#include "tests/net/support/hex.h"

#include <sodium.h>

#include <algorithm>
#include <stdexcept>

namespace platon {

Bytes fromHex(std::string_view text) {
  Bytes bytes(text.size() / 2);
  std::size_t size = 0;
  const char* end = nullptr;
  const int result = sodium_hex2bin(bytes.data(), bytes.size(), text.data(), text.size(), nullptr, &size, &end);
  if (result != 0 || end != text.data() + text.size() || size != bytes.size()) {
    throw std::invalid_argument("not hexadecimal: " + std::string(text));
  }
  return bytes;
}

CryptoKey keyFromHex(std::string_view text) {
  const Bytes bytes = fromHex(text);
  CryptoKey key;
  if (bytes.size() != key.size()) throw std::invalid_argument("not a key: " + std::string(text));
  std::copy(bytes.begin(), bytes.end(), key.begin());
  return key;
}

std::string toHex(ByteSpan bytes) {
  std::string text(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  text.pop_back();
  return text;
}

}  // namespace platon
