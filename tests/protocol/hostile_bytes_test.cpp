#include <gtest/gtest.h>

#include "protocol/bytes.h"

#include <random>

#include "tests/protocol/sample_messages.h"

namespace platon::hostile_bytes_test {
namespace {

/// Changes, swaps, removes or inserts a few bytes.
Bytes mutated(Bytes bytes, std::mt19937_64& random) {
  const auto changes = 1 + random() % 4;
  for (std::uint64_t i = 0; i < changes && !bytes.empty(); ++i) {
    const std::size_t at = random() % bytes.size();
    switch (random() % 6) {
      case 0:
        bytes[at] ^= static_cast<std::uint8_t>(1 << random() % 8);
        break;
      case 1:
        bytes[at] = static_cast<std::uint8_t>(random());
        break;
      case 2:
        bytes[at] = random() % 2 == 0 ? 0x00 : 0xff;
        break;
      case 3:
        std::swap(bytes[at], bytes[random() % bytes.size()]);
        break;
      case 4:
        bytes.resize(at);
        break;
      default:
        bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), static_cast<std::uint8_t>(random()));
        break;
    }
  }
  return bytes;
}

Bytes noise(std::mt19937_64& random) {
  Bytes bytes(random() % 80);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  return bytes;
}

/// Checks that a decoded message is within its limits, as `encode` asserts, and equal after encoding and decoding it
/// again.
template <class Variant>
void expectValid(const std::optional<Variant>& decoded, std::optional<Variant> (*decode)(std::span<const std::uint8_t>),
                 std::uint64_t& accepted) {
  if (!decoded) return;
  ++accepted;
  ASSERT_EQ(decode(encodeAny(*decoded)), decoded);
}

template <class Variant>
void attack(const std::vector<Variant>& samples, std::optional<Variant> (*decode)(std::span<const std::uint8_t>),
            int rounds) {
  constexpr std::uint64_t seed = 20240611;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::vector<Bytes> encoded;
  for (const Variant& sample : samples) encoded.push_back(encodeAny(sample));
  std::uint64_t accepted = 0;
  for (int round = 0; round < rounds; ++round) {
    const Bytes bytes = round % 8 == 0 ? noise(random) : mutated(encoded[random() % encoded.size()], random);
    expectValid(decode(bytes), decode, accepted);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(accepted, 0u);
}

constexpr int kRounds = 150000;

TEST(HostileBytes, NeverDecodeToAnInvalidMessageToTheServer) { attack(sampleToServer(), &decodeToServer, kRounds); }

TEST(HostileBytes, NeverDecodeToAnInvalidMessageToTheClient) { attack(sampleToClient(), &decodeToClient, kRounds); }

}  // namespace
}  // namespace platon::hostile_bytes_test
