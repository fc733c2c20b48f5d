#include "server/admin/announcement.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "protocol/files/private_file.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

using Servers = std::vector<ListedServer>;

KeptFile listAt(const std::string& file) { return {file, kMaxServerListBytes, KeptFile::Kind::kPublished}; }

// The servers in the text of a file, none if that is empty or new; or what is wrong with it.
std::variant<Servers, ParseError> serversIn(const std::string& text) {
  if (text.empty()) return Servers();
  auto read = readServerList(text);
  const auto* error = std::get_if<ParseError>(&read);
  auto* const list = std::get_if<ServerList>(&read);
  if (list != nullptr && list->faults.empty()) return std::move(list->servers);
  return ParseError{(error != nullptr ? error->what : list->faults.front()) +
                    "; correct the file or name another one after --announce"};
}

// Puts `own`, a list with the entry at this address or with none, in place of the entry that a list has there.
std::variant<std::string, ParseError> replaceEntry(const std::string& kept, const ServerAddress& address,
                                                   std::string_view own) {
  auto read = serversIn(kept);
  if (auto* error = std::get_if<ParseError>(&read)) return std::move(*error);
  Servers& servers = std::get<Servers>(read);
  const auto before =
      std::find_if(servers.begin(), servers.end(), [&](const ListedServer& each) { return each.address == address; });
  const Servers wanted = std::get<ServerList>(readServerList(own)).servers;
  if (before == servers.end() ? wanted.empty() : wanted == std::vector{*before}) return kept;
  if (before != servers.end()) servers.erase(before);
  servers.insert(servers.end(), wanted.begin(), wanted.end());
  if (servers.size() > kMaxListedServers)
    return ParseError{"the list is full: it has " + std::to_string(kMaxListedServers) + " servers; remove one of them"};
  return serverListText(servers);
}

FileWriter::Replace replaceEntryAt(const ServerAddress& address) {
  return [address](const std::string& file, std::string_view own) {
    return listAt(file).change([&](const std::string& kept) { return replaceEntry(kept, address, own); });
  };
}

// Why a server cannot be announced in a file; empty if it can.
std::string faultOf(const std::string& file) {
  const auto text = listAt(file).read();
  if (const auto* error = std::get_if<ParseError>(&text)) return error->what;
  const auto servers = serversIn(std::get<std::string>(text));
  const auto* error = std::get_if<ParseError>(&servers);
  return error == nullptr ? "" : error->what;
}

}  // namespace

Announcement::Announcement(const std::string& file, const ServerIdentity& identity, ServerAddress address)
    : identity_(identity),
      address_(std::move(address)),
      file_(std::make_unique<FileWriter>(file, startThread, replaceEntryAt(address_))) {
  if (const std::string fault = faultOf(file); !fault.empty())
    throw ProgramError(ProgramError::kUsage, "cannot announce the server in '" + file + "': " + fault);
}

void Announcement::enter(std::string_view name) { write(true, {listedServer(identity_, address_, name)}); }

void Announcement::leave() { write(false, {}); }

void Announcement::write(bool enters, const std::vector<ListedServer>& own) {
  enters_ = enters;
  told_ = false;
  file_->write(serverListText(own));
}

std::optional<Announcement::Outcome> Announcement::poll(FileWriter::Time now) { return outcomeOf(file_->poll(now)); }

std::optional<Announcement::Outcome> Announcement::finish() { return outcomeOf(file_->finish()); }

std::optional<Announcement::Outcome> Announcement::outcomeOf(const std::optional<std::string>& fault) {
  if (fault) return Outcome{enters_, *fault};
  if (told_ || file_->pending()) return std::nullopt;
  told_ = true;
  return Outcome{enters_, {}};
}

std::optional<Announcement> announcementOf(const std::string& file, const std::string& address,
                                           const ServerIdentity& identity) {
  if (file.empty()) return std::nullopt;
  if (address.empty()) {
    throw ProgramError(ProgramError::kUsage,
                       "announce needs the address at which players reach this server: set announce-as, for example to "
                       "play.example.org:7777");
  }
  return Announcement(file, identity, parseServerAddress(address));
}

}  // namespace platon
