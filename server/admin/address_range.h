#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "protocol/files/parse_error.h"
#include "protocol/transport/socket_address.h"

namespace platon {

/// All addresses that share their first bits: `192.0.2.0/24`, `2001:db8::/32`, or a single address. A range holds
/// either IPv4 or IPv6 addresses, so `::/0` holds no IPv4 address.
class AddressRange {
 public:
  /// Bits of an address in its IPv6 form, and those of them that all IPv4 addresses share.
  static constexpr unsigned kBits = 128;
  static constexpr unsigned kIpv4Bits = 96;

  /// The range of one address.
  explicit AddressRange(const IpAddress& address) : first_(address) {}
  /// The range with this many fixed bits that starts with those of the address; 0 … kBits.
  static AddressRange around(const IpAddress& address, unsigned bits);
  /// The range of the household of an address: see `IpAddress::household`.
  static AddressRange householdOf(const IpAddress& address);

  /// Reads an address, alone or with `/` and the number of its fixed bits. Refuses a range whose first address has a
  /// bit set that is not fixed, because one of the two is a mistake.
  static std::variant<AddressRange, ParseError> parse(std::string_view text);
  /// Such as `192.0.2.0/24`; a single address without the number of bits.
  std::string text() const;

  bool contains(const IpAddress& address) const;

  const IpAddress& first() const { return first_; }
  /// Fixed bits of the IPv6 form: 0 … kBits; at least kIpv4Bits if the addresses are IPv4.
  unsigned bits() const { return bits_; }

  friend bool operator==(const AddressRange&, const AddressRange&) = default;
  /// By first address, then by number of bits.
  friend bool operator<(const AddressRange& a, const AddressRange& b) {
    return a.first_ != b.first_ ? a.first_ < b.first_ : a.bits_ < b.bits_;
  }

 private:
  AddressRange(const IpAddress& first, unsigned bits) : first_(first), bits_(bits) {}

  IpAddress first_;
  unsigned bits_ = kBits;
};

}  // namespace platon
