#include "server/admin/announcement.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>
#include <variant>

#include "protocol/files/private_file.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

// The servers in a file, none if it does not exist; or what is wrong with it.
std::variant<std::vector<ListedServer>, ParseError> serversIn(const std::string& file) {
  std::error_code fault;
  const bool exists = std::filesystem::exists(file, fault);
  if (fault) return ParseError{fault.message()};
  if (!exists) return std::vector<ListedServer>();
  const auto text = readTextFile(file, kMaxServerListBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) return *error;
  auto read = readServerList(std::get<std::string>(text));
  if (const auto* error = std::get_if<ParseError>(&read)) return *error;
  auto& list = std::get<ServerList>(read);
  if (!list.faults.empty()) return ParseError{list.faults.front()};
  return std::move(list.servers);
}

// Puts `own`, a list with the entry at this address or with none, in place of the entry that a file has there. Returns
// why that failed, or an empty text.
std::string replaceEntry(const std::string& file, const ServerAddress& address, std::string_view own) {
  const OpenedFile lock = lockBeside(file, WithoutLocks::kRefuse);
  if (!lock.file) return lock.fault;
  auto read = serversIn(file);
  if (const auto* error = std::get_if<ParseError>(&read)) return error->what;
  auto& servers = std::get<std::vector<ListedServer>>(read);
  const auto before =
      std::find_if(servers.begin(), servers.end(), [&](const ListedServer& each) { return each.address == address; });
  const auto wanted = std::get<ServerList>(readServerList(own)).servers;
  if (before == servers.end() ? wanted.empty() : wanted == std::vector{*before}) return {};
  if (before != servers.end()) servers.erase(before);
  servers.insert(servers.end(), wanted.begin(), wanted.end());
  if (servers.size() > kMaxListedServers)
    return "the list is full: it has " + std::to_string(kMaxListedServers) + " servers; remove one of them";
  return replacePublicFile(file, serverListText(servers));
}

// In the thread of the writer, which takes no exceptions.
FileWriter::Replace replaceEntryAt(const ServerAddress& address) {
  return [address](const std::string& file, std::string_view own) -> std::string {
    try {
      return replaceEntry(file, address, own);
    } catch (const std::exception& error) {
      return error.what();
    }
  };
}

}  // namespace

Announcement::Announcement(const std::string& file, const ServerIdentity& identity, ServerAddress address)
    : identity_(identity),
      address_(std::move(address)),
      file_(std::make_unique<FileWriter>(file, startThread, replaceEntryAt(address_))) {
  const auto servers = serversIn(file);
  if (const auto* error = std::get_if<ParseError>(&servers)) {
    throw ProgramError(ProgramError::kUsage, "cannot announce the server in '" + file + "': " + error->what +
                                                 "; correct the file or name another one after --announce");
  }
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
