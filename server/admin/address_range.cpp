#include "server/admin/address_range.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "platon/game/diagnostics.h"

namespace platon {
namespace {

constexpr unsigned kHouseholdBits = 64;

std::optional<IpAddress> addressOf(std::string_view text) {
  return text.find('\0') == std::string_view::npos ? IpAddress::parse(text) : std::nullopt;
}

// The address with all bits but the first `bits` cleared.
IpAddress masked(IpAddress address, unsigned bits) {
  for (unsigned i = 0; i < address.bytes.size(); ++i) {
    const unsigned kept = bits > 8 * i ? std::min(bits - 8 * i, 8u) : 0;
    address.bytes[i] = static_cast<std::uint8_t>(address.bytes[i] & (0xff00u >> kept));
  }
  return address;
}

}  // namespace

AddressRange AddressRange::around(const IpAddress& address, unsigned bits) { return {masked(address, bits), bits}; }

AddressRange AddressRange::householdOf(const IpAddress& address) {
  return around(address, address.holdsIpv4() ? kBits : kHouseholdBits);
}

std::variant<AddressRange, ParseError> AddressRange::parse(std::string_view text) {
  const std::size_t slash = text.find('/');
  const auto address = addressOf(text.substr(0, slash));
  if (!address) {
    return ParseError{quoted(text) + " is not an address or a range of addresses, such as 192.0.2.7 or 2001:db8::/32"};
  }
  if (slash == std::string_view::npos) return AddressRange(*address);
  const std::string_view number = text.substr(slash + 1);
  const bool dotted = text.find(':') == std::string_view::npos;
  const unsigned most = dotted ? kBits - kIpv4Bits : kBits;
  unsigned bits = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), bits);
  if (error != std::errc() || end != number.data() + number.size() || bits > most) {
    return ParseError{"the number after the / of " + quoted(text) + " must be 0 to " + std::to_string(most)};
  }
  if (dotted) bits += kIpv4Bits;
  const AddressRange range = around(*address, bits);
  if (range.first_ == *address) return range;
  return ParseError{quoted(text) + " has bits after its first " + std::string(number) + ": write " + range.text()};
}

std::string AddressRange::text() const {
  if (bits_ == kBits) return first_.text();
  return first_.text() + "/" + std::to_string(first_.isIpv4() ? bits_ - kIpv4Bits : bits_);
}

bool AddressRange::contains(const IpAddress& address) const {
  return address.isIpv4() == first_.isIpv4() && masked(address, bits_) == first_;
}

}  // namespace platon
