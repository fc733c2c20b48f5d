#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace platon {

/// Immutable bytes with any number of owners, such as a message to many clients. A copy shares them. A range, from
/// which a std::span can be made.
class SharedBytes {
 public:
  /// No bytes.
  SharedBytes() : SharedBytes(std::vector<std::uint8_t>()) {}
  SharedBytes(std::vector<std::uint8_t> bytes)
      : bytes_(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))) {}

  const std::uint8_t* data() const { return bytes_->data(); }
  std::size_t size() const { return bytes_->size(); }
  const std::uint8_t* begin() const { return data(); }
  const std::uint8_t* end() const { return data() + size(); }

 private:
  std::shared_ptr<const std::vector<std::uint8_t>> bytes_;
};

}  // namespace platon
