#include "server/admin/ban_store.h"

#include <utility>

#include "protocol/files/text_file.h"

namespace platon {
namespace {

// Longest line of a ban that the server adds.
constexpr std::size_t kMaxBanBytes = 256;

}  // namespace

std::variant<BanList, std::vector<std::string>> readBanFile(const std::string& path) {
  auto text = readTextFile(path, BanList::kMaxBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) {
    return std::vector{path + ": error: " + error->what + "; name a readable ban file; it may be empty"};
  }
  auto parsed = BanList::parse(std::get<std::string>(text));
  if (auto* list = std::get_if<BanList>(&parsed)) return std::move(*list);
  std::vector<std::string> errors;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) errors.push_back(format(path, one));
  return errors;
}

BanStore::BanStore(const std::string& path, BanList list)
    : path_(path), file_(std::make_unique<FileWriter>(path)), list_(std::move(list)) {}

std::optional<ParseError> BanStore::add(const Ban& ban, UtcTime now) {
  if (auto error = readAgain()) return error;
  if (list_.text().size() + kMaxBanBytes > BanList::kMaxBytes) {
    return ParseError{"the ban file is full: remove bans from it"};
  }
  list_.add(ban);
  save(now);
  return std::nullopt;
}

std::optional<ParseError> BanStore::remove(const AddressRange& range, UtcTime now) {
  if (auto error = readAgain()) return error;
  if (!list_.remove(range)) {
    const Ban* other = list_.find(range.first(), now);
    const bool wider = other && other->range.bits() < range.bits();
    return ParseError{"there is no ban of " + range.text() +
                      (wider ? "; it is part of " + other->range.text() : "; the command bans lists all")};
  }
  save(now);
  return std::nullopt;
}

std::optional<ParseError> BanStore::replace(BanList list) {
  if (!file_) return std::nullopt;
  if (pending()) {
    return ParseError{path_ +
                      ": error: the last change of the bans is not written to this file yet, and will replace what is "
                      "in it; reload again when it is written"};
  }
  list_ = std::move(list);
  return std::nullopt;
}

std::optional<std::string> BanStore::poll(FileWriter::Time now) { return file_ ? file_->poll(now) : std::nullopt; }

// A file that does not hold the newest list yet is older than the list.
std::optional<ParseError> BanStore::readAgain() {
  if (!file_ || pending()) return std::nullopt;
  auto read = readBanFile(path_);
  if (const auto* errors = std::get_if<std::vector<std::string>>(&read)) {
    return ParseError{errors->front() + "; nothing has changed: correct the file first"};
  }
  list_ = std::get<BanList>(std::move(read));
  return std::nullopt;
}

void BanStore::save(UtcTime now) {
  list_.removeEnded(now);
  if (file_) file_->write(list_.text());
}

}  // namespace platon
