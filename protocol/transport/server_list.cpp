#include "protocol/transport/server_list.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

#include "protocol/label.h"
#include "protocol/limits.h"

namespace platon {
namespace {

// Keeps the order in which the keys of an entry are written. An object of it that grows copies its values, each in a
// recursion, so nothing is read into it.
using WrittenJson = nlohmann::ordered_json;
using Json = nlohmann::json;

constexpr const char* kServers = "platonServers";
// Most arrays and objects in each other. A list needs three.
constexpr int kMaxDepth = 8;

// What a server signs. A label has no line feed, nor has an address.
std::string signedText(const ServerAddress& address, std::string_view name) {
  return "platon server list\n" + address.text() + "\n" + std::string(name);
}

std::string textIn(const Json& entry, const char* key) {
  const auto found = entry.find(key);
  if (found == entry.end() || !found->is_string())
    throw std::invalid_argument(std::string("\"") + key + "\" must be a string");
  return found->get<std::string>();
}

ListedServer readEntry(const Json& entry) {
  if (!entry.is_object()) throw std::invalid_argument("it must be an object");
  ListedServer server;
  const std::string address = textIn(entry, "address");
  if (!isNextServer(address)) throw std::invalid_argument("\"address\" must be HOST:PORT of at most 128 bytes");
  server.address = parseServerAddress(address);
  server.name = textIn(entry, "name");
  if (!isLabel(server.name, kMaxNameBytes))
    throw std::invalid_argument("\"name\" must be a text of at most " + std::to_string(kMaxNameBytes) +
                                " bytes without control characters");
  const auto key = keyOf(textIn(entry, "key"));
  const auto signature = signatureOf(textIn(entry, "signature"));
  if (!key) throw std::invalid_argument("\"key\" is not the key of a server");
  if (!signature || !isSignature(*signature, signedText(server.address, server.name), *key))
    throw std::invalid_argument("the signature does not match the entry; let the server write the entry again");
  server.key = *key;
  server.signature = *signature;
  return server;
}

void refuseTwins(const std::vector<ListedServer>& servers, const ListedServer& server) {
  const std::string address = server.address.text();
  if (std::any_of(servers.begin(), servers.end(),
                  [&](const ListedServer& other) { return other.address.text() == address; }))
    throw std::invalid_argument("another entry has this address; remove one of the two");
}

// Leaves out what is nested too deeply, so that nothing which walks through the result has to go deeper.
Json parse(std::string_view text, bool& tooDeep) {
  using Event = Json::parse_event_t;
  const auto keeps = [&tooDeep](int depth, Event event, const Json&) {
    const bool begins = event == Event::array_start || event == Event::object_start;
    tooDeep = tooDeep || (begins && depth >= kMaxDepth);
    return !begins || depth < kMaxDepth;
  };
  return Json::parse(text, keeps, false);
}

}  // namespace

ListedServer listedServer(const ServerIdentity& identity, const ServerAddress& address, std::string_view name) {
  return {address, std::string(name), identity.publicKey(), identity.sign(signedText(address, name))};
}

std::string serverListText(const std::vector<ListedServer>& servers) {
  WrittenJson entries = WrittenJson::array();
  for (const ListedServer& server : servers) {
    entries.push_back({{"address", server.address.text()},
                       {"name", server.name},
                       {"key", textOf(server.key)},
                       {"signature", textOf(server.signature)}});
  }
  return WrittenJson{{kServers, entries}}.dump(2) + "\n";
}

std::variant<ServerList, ParseError> readServerList(std::string_view text) {
  bool tooDeep = false;
  const Json json = text.size() <= kMaxServerListBytes ? parse(text, tooDeep) : Json();
  if (tooDeep)
    return ParseError{"its arrays and objects are nested more than " + std::to_string(kMaxDepth) +
                      " deep; take these out"};
  const auto entries = json.find(kServers);
  if (entries == json.end() || !entries->is_array())
    return ParseError{"it is not a list of servers, which is JSON of at most 512 KiB with the key \"platonServers\""};
  if (entries->size() > kMaxListedServers)
    return ParseError{"it has more than " + std::to_string(kMaxListedServers) + " servers; remove some"};
  ServerList list;
  for (std::size_t i = 0; i < entries->size(); ++i) {
    try {
      const ListedServer server = readEntry((*entries)[i]);
      refuseTwins(list.servers, server);
      list.servers.push_back(server);
    } catch (const std::invalid_argument& error) {
      list.faults.push_back("server " + std::to_string(i + 1) + " of the list: " + error.what());
    }
  }
  return list;
}

}  // namespace platon
