#include "server/admin/announcement.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <variant>
#include <vector>

#include "protocol/files/descriptor.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"

namespace platon {
namespace {

// Lets one server at a time change a file. The lock is on a file beside it, because the file itself is replaced.
class FileLock {
 public:
  explicit FileLock(const std::string& file)
      : lock_(::open((file + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644)) {
    if (!lock_ || flock(lock_.number(), LOCK_EX) != 0) fault_ = std::strerror(errno);
  }

  const std::string& fault() const { return fault_; }

 private:
  Descriptor lock_;
  std::string fault_;
};

// The servers in a file, none if it does not exist; or what is wrong with it.
std::variant<std::vector<ListedServer>, ParseError> serversIn(const std::string& file) {
  if (!std::filesystem::exists(file)) return std::vector<ListedServer>();
  const auto text = readTextFile(file, kMaxServerListBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) return *error;
  auto read = readServerList(std::get<std::string>(text));
  if (const auto* error = std::get_if<ParseError>(&read)) return *error;
  auto& list = std::get<ServerList>(read);
  if (!list.faults.empty()) return ParseError{list.faults.front()};
  return std::move(list.servers);
}

}  // namespace

Announcement::Announcement(std::string file, const ServerIdentity& identity, ServerAddress address)
    : file_(std::move(file)), identity_(identity), address_(std::move(address)) {
  const auto servers = serversIn(file_);
  if (const auto* error = std::get_if<ParseError>(&servers)) {
    throw ProgramError(ProgramError::kUsage, "cannot announce the server in '" + file_ + "': " + error->what +
                                                 "; correct the file or name another one after --announce");
  }
}

std::string Announcement::enter(std::string_view name) {
  const ListedServer own = listedServer(identity_, address_, name);
  return write(&own);
}

std::string Announcement::leave() { return write(nullptr); }

std::string Announcement::write(const ListedServer* own) {
  const FileLock lock(file_);
  if (!lock.fault().empty()) return lock.fault();
  auto read = serversIn(file_);
  if (const auto* error = std::get_if<ParseError>(&read)) return error->what;
  auto& servers = std::get<std::vector<ListedServer>>(read);
  std::erase_if(servers, [&](const ListedServer& server) {
    return server.key == identity_.publicKey() || server.address == address_;
  });
  if (own != nullptr) servers.push_back(*own);
  if (servers.size() > kMaxListedServers) return "the list is full: it has 1000 servers";
  return replaceTextFile(file_, serverListText(servers));
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
