#include "client/lobby/kept_file.h"

#include <system_error>
#include <utility>
#include <variant>

#include "protocol/files/text_file.h"

namespace platon {

std::optional<std::string> readKeptFile(const std::filesystem::path& file, std::size_t maxBytes) {
  auto content = readTextFile(file.string(), maxBytes);
  if (auto* const text = std::get_if<std::string>(&content)) return std::move(*text);
  std::error_code ignored;
  const bool missing = std::filesystem::status(file, ignored).type() == std::filesystem::file_type::not_found;
  return missing ? std::optional(std::string()) : std::nullopt;
}

}  // namespace platon
