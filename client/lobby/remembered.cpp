#include "client/lobby/remembered.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <variant>

#include "protocol/files/word_reader.h"
#include "protocol/hash_text.h"
#include "protocol/program_error.h"
#include "protocol/transport/server_identity.h"

namespace platon {

namespace {

struct KnownServer {
  std::string address;
  CryptoKey key;
};

bool isAddress(const std::string& text) {
  try {
    return parseServerAddress(text).text() == text;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Nothing if the line is damaged.
std::optional<KnownServer> parse(std::string_view line) {
  WordReader words(line);
  const std::string address(words.next());
  const std::optional<CryptoKey> key = keyOf(words.next());
  if (!key || !words.peek().empty() || !isAddress(address)) return std::nullopt;
  return KnownServer{address, *key};
}

[[noreturn]] void refuse(const std::string& place, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, place + ": error: " + why);
}

// Most bytes of the file: thousands of servers.
constexpr std::size_t kMaxKnownBytes = std::size_t{1} << 20;

}  // namespace

KnownServers::KnownServers(std::filesystem::path file) : file_(std::move(file), kMaxKnownBytes) {}

std::optional<CryptoKey> KnownServers::findIn(const std::string& text, const ServerAddress& server) const {
  std::optional<CryptoKey> found;
  for (TextLines lines(text); lines.nextEntry();) {
    const std::optional<KnownServer> known = parse(lines.line());
    if (!known) {
      refuse(file().string() + ":" + std::to_string(lines.number()),
             "damaged line, expected HOST:PORT KEY; correct or remove it. If you remove it, the key of the server is "
             "saved again when you join");
    }
    if (!found && known->address == server.text()) found = known->key;
  }
  return found;
}

std::optional<CryptoKey> KnownServers::find(const ServerAddress& server) const {
  const auto text = file_.read();
  if (const auto* error = std::get_if<ParseError>(&text)) refuse(file().string(), error->what);
  return findIn(std::get<std::string>(text), server);
}

std::string KnownServers::remember(const ServerAddress& server, const CryptoKey& key) const {
  const auto add = [&](const std::string& kept) {
    if (findIn(kept, server)) return kept;
    return kept + (kept.empty() || kept.ends_with('\n') ? "" : "\n") + server.text() + " " + textOf(key) + "\n";
  };
  try {
    const std::string fault = file_.change(add);
    return fault.empty() ? fault : "cannot save the key of the server: " + file().string() + ": " + fault;
  } catch (const ProgramError& error) {
    return error.what();
  }
}

namespace {

constexpr std::size_t kMaxFileBytes = 64 * 1024;

std::vector<ServerAddress> serversIn(const std::string& text) {
  std::vector<ServerAddress> servers;
  for (TextLines lines(text); servers.size() < RecentServers::kMaxServers && lines.nextEntry();) {
    try {
      servers.push_back(parseServerAddress(lines.line()));
    } catch (const std::invalid_argument&) {
      continue;  // the player has changed the file
    }
  }
  return servers;
}

}  // namespace

RecentServers::RecentServers(std::filesystem::path file) : file_(std::move(file), kMaxFileBytes) {}

std::vector<ServerAddress> RecentServers::list() const {
  const auto text = file_.read();
  return std::holds_alternative<ParseError>(text) ? std::vector<ServerAddress>()
                                                  : serversIn(std::get<std::string>(text));
}

void RecentServers::remember(const ServerAddress& server) const {
  const auto first = [&](const std::string& kept) {
    std::string text = server.text() + "\n";
    for (const ServerAddress& other : serversIn(kept)) {
      if (other.text() != server.text()) text += other.text() + "\n";
    }
    return text;
  };
  file_.change(first);
}

namespace {

constexpr const char* kHead = "# Levels whose goal you have reached: the hash of each.\n";
constexpr std::size_t kMaxBytes = ReachedLevels::kMaxLevels * 32;

std::vector<std::uint64_t> levelsIn(const std::string& text) {
  std::vector<std::uint64_t> levels;
  for (TextLines lines(text); lines.nextEntry();) {
    if (const std::optional<std::uint64_t> hash = hashIn(lines.line())) levels.push_back(*hash);
  }
  return levels;
}

}  // namespace

ReachedLevels::ReachedLevels(std::filesystem::path file) : file_(std::move(file), kMaxBytes) {
  const auto text = file_.read();
  if (const auto* const kept = std::get_if<std::string>(&text)) levels_ = levelsIn(*kept);
}

bool ReachedLevels::has(std::uint64_t level) const {
  return std::find(levels_.begin(), levels_.end(), level) != levels_.end();
}

// Another program may have added some.
std::string ReachedLevels::add(std::uint64_t level) {
  if (file_.path().empty() || has(level)) return {};
  levels_.push_back(level);
  const auto addTo = [&](const std::string& kept) {
    levels_ = levelsIn(kept);
    if (!has(level)) levels_.push_back(level);
    if (levels_.size() > kMaxLevels) levels_.erase(levels_.begin(), levels_.end() - kMaxLevels);
    std::string text = kHead;
    for (const std::uint64_t each : levels_) text += hashText(each) + "\n";
    return text;
  };
  const std::string fault = file_.change(addTo, KeptFile::Wait::kNot);
  if (fault.empty()) return {};
  return "cannot save that the goal was reached: " + file_.path().string() + ": " + fault;
}

}  // namespace platon
