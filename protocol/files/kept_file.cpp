#include "protocol/files/kept_file.h"

#include <system_error>

#include "protocol/files/private_file.h"

namespace platon {

std::variant<std::string, ParseError> KeptFile::read() const {
  if (path_.empty()) return std::string();
  auto content = readTextFile(path_.string(), maxBytes_);
  const auto* const text = std::get_if<std::string>(&content);
  if (text != nullptr && text->size() > maxBytes_)
    return ParseError{"it has more than " + std::to_string(maxBytes_) + " bytes"};
  std::error_code ignored;
  const bool missing = std::filesystem::status(path_, ignored).type() == std::filesystem::file_type::not_found;
  return text == nullptr && missing ? std::string() : std::move(content);
}

std::string KeptFile::change(const Edit& edit, FileReplacement::Wait wait) const {
  if (path_.empty()) return {};
  std::error_code ignored;  // locking reports the error
  std::filesystem::create_directories(folderOf(path_), ignored);
  const OpenedFile lock = lockBeside(path_.string(), WithoutLocks::kGoOn);
  if (!lock.file) return lock.fault;
  const auto before = read();
  if (const auto* error = std::get_if<ParseError>(&before)) return error->what;
  FileReplacement replacement(path_.string());
  replacement.write(edit(std::get<std::string>(before)));
  return replacement.finish(wait, FileReplacement::Readers::kOwner);
}

}  // namespace platon
