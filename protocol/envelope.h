#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "flatbuffers/flatbuffers.h"
#include "protocol/limits.h"

namespace platon {

/// First byte of a per-tick message. Its fields follow without a FlatBuffer around them; in a FlatBuffer of ours this
/// byte is the offset of the root table, which is not 0.
inline constexpr std::uint8_t kTickMessage = 0;

inline bool isTickMessage(std::span<const std::uint8_t> bytes) {
  return !bytes.empty() && bytes.size() <= kMaxMessageBytes && bytes[0] == kTickMessage;
}

/// A received FlatBuffer whose structure has been verified. The values of its fields are not checked.
template <class Root>
class Envelope {
 public:
  /// Copies the bytes, since FlatBuffers needs them aligned.
  explicit Envelope(std::span<const std::uint8_t> bytes) {
    if (bytes.empty() || bytes.size() > kMaxMessageBytes) return;
    words_.resize((bytes.size() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t));
    std::memcpy(words_.data(), bytes.data(), bytes.size());
    const auto* start = reinterpret_cast<const std::uint8_t*>(words_.data());
    constexpr flatbuffers::uoffset_t depth = 4;
    constexpr flatbuffers::uoffset_t tables = 4 + kMaxRosterEntries;
    flatbuffers::Verifier verifier(start, bytes.size(), depth, tables);
    if (verifier.VerifyBuffer<Root>(nullptr)) root_ = flatbuffers::GetRoot<Root>(start);
  }

  /// Null when the bytes are not a valid FlatBuffer of this type.
  const Root* root() const { return root_; }

 private:
  std::vector<std::uint64_t> words_;
  const Root* root_ = nullptr;
};

/// The bytes of a finished builder.
inline std::vector<std::uint8_t> bytesOf(const flatbuffers::FlatBufferBuilder& builder) {
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

/// A missing field reads as empty.
inline std::span<const std::uint8_t> spanOf(const flatbuffers::Vector<std::uint8_t>* vector) {
  return vector ? std::span<const std::uint8_t>(vector->data(), vector->size()) : std::span<const std::uint8_t>();
}
inline std::string textOf(const flatbuffers::String* text) { return text ? text->str() : std::string(); }

}  // namespace platon
