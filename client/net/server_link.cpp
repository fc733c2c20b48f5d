#include "client/net/server_link.h"

#include <algorithm>

namespace platon {
namespace {

constexpr std::string_view kScheme = "platon://";

// Schemes may be written in capitals, too.
bool beginsWithScheme(std::string_view text) {
  const auto same = [](char own, char other) {
    return own == (other >= 'A' && other <= 'Z' ? other - 'A' + 'a' : other);
  };
  return text.size() >= kScheme.size() && std::equal(kScheme.begin(), kScheme.end(), text.begin(), same);
}

}  // namespace

std::string_view addressOfLink(std::string_view text) {
  if (!beginsWithScheme(text)) return text;
  text.remove_prefix(kScheme.size());
  if (text.ends_with('/')) text.remove_suffix(1);
  return text;
}

}  // namespace platon
