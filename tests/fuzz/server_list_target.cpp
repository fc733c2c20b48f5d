#include <algorithm>
#include <array>
#include <set>

#include "protocol/label.h"
#include "protocol/limits.h"
#include "protocol/transport/server_list.h"
#include "tests/fuzz/byte_source.h"
#include "tests/fuzz/error_faults.h"
#include "tests/fuzz/fuzz_targets.h"

namespace platon::fuzz {
namespace {

bool isSentence(const std::string& error) { return !error.empty() && error.size() <= 200 && isPrintable(error); }

std::string readFault(const std::string& text) {
  const auto read = readServerList(text);
  if (const auto* error = std::get_if<ParseError>(&read)) return isSentence(error->what) ? "" : "no sentence";
  const auto& list = std::get<ServerList>(read);
  if (!std::all_of(list.faults.begin(), list.faults.end(), isSentence)) return "a fault that is no sentence";
  if (list.servers.size() + list.faults.size() > kMaxListedServers) return "more entries than a list may have";
  std::set<std::string> addresses;
  for (const ListedServer& server : list.servers) {
    if (!isLabel(server.name, kMaxNameBytes)) return "a name that cannot be shown";
    if (!isNextServer(server.address.text())) return "an address that is none";
    if (!addresses.insert(server.address.text()).second) return "two servers at one address";
  }
  const auto again = readServerList(serverListText(list.servers));
  const auto* same = std::get_if<ServerList>(&again);
  return same && same->faults.empty() && same->servers == list.servers ? "" : "the list differs after writing";
}

// A list that is signed, which no change of a text leads to, and what a reader should find in it.
class SignedList {
 public:
  explicit SignedList(ByteSource& bytes) : bytes_(bytes) {
    constexpr int kMaxEntries = 8;
    for (int i = 0; i < kMaxEntries && !bytes_.empty(); ++i) add();
  }

  std::string fault() {
    std::string text = serverListText(entries_);
    const bool changed = bytes_.below(4) == 3;
    if (changed) text[bytes_.below(text.size())] = static_cast<char>(bytes_.byte());
    if (std::string fault = readFault(text); !fault.empty() || changed) return fault;
    const auto read = readServerList(text);
    const auto* list = std::get_if<ServerList>(&read);
    if (!list || list->servers != expected_) return "other servers are read than were signed";
    return list->faults.size() == entries_.size() - expected_.size() ? "" : "not every entry that is left out is told";
  }

 private:
  static const ServerIdentity& identity(std::size_t index) {
    static const std::array<ServerIdentity, 3> identities{ServerIdentity(CryptoKey{1}), ServerIdentity(CryptoKey{2}),
                                                          ServerIdentity(CryptoKey{3})};
    return identities.at(index);
  }

  std::string characters(std::size_t most) {
    std::string text(bytes_.below(most + 1), '\0');
    for (char& character : text) character = static_cast<char>(bytes_.byte());
    return text;
  }

  std::string label() {
    const std::string text = characters(kMaxNameBytes);
    return isLabel(text, kMaxNameBytes) ? text : "Example";
  }

  ServerAddress address() {
    const std::string text = bytes_.flag() ? characters(40) : std::string(1, "abc"[bytes_.below(3)]);
    return isNextServer(text) ? parseServerAddress(text) : ServerAddress{"a.example", 1};
  }

  void add() {
    const ServerAddress at = address();
    ListedServer entry = listedServer(identity(bytes_.below(3)), at, label());
    const ListedServer asSigned = entry;
    change(entry);
    const bool twin = std::any_of(expected_.begin(), expected_.end(), [&](const ListedServer& other) {
      return other.address.text() == entry.address.text();
    });
    if (entry == asSigned && !twin) expected_.push_back(entry);
    entries_.push_back(std::move(entry));
  }

  // Mostly changes nothing.
  void change(ListedServer& entry) {
    switch (bytes_.below(8)) {
      case 4:
        entry.signature.at(bytes_.below(entry.signature.size())) ^= static_cast<std::uint8_t>(1 << bytes_.below(8));
        break;
      case 5:
        entry.name = label();
        break;
      case 6:
        entry.address = address();
        break;
      case 7:
        entry.key = identity(bytes_.below(3)).publicKey();
        break;
      default:
        break;
    }
  }

  ByteSource& bytes_;
  std::vector<ListedServer> entries_;
  std::vector<ListedServer> expected_;
};

}  // namespace

// No text of JSON begins with such a byte.
std::string serverListFault(Bytes bytes) {
  if (bytes.empty() || bytes[0] < 0x80) return readFault(std::string(bytes.begin(), bytes.end()));
  ByteSource source(bytes.subspan(1));
  return SignedList(source).fault();
}

}  // namespace platon::fuzz
