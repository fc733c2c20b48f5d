#include "client/files/edit_file.h"

#include <system_error>
#include <utility>
#include <variant>

#include "platon/game/level.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"

namespace platon {

bool EditFile::exists() const {
  std::error_code ignored;
  return std::filesystem::exists(path_, ignored);
}

std::string EditFile::load() {
  auto text = readTextFile(path_.string(), kMaxLevelBytes);
  if (const auto* fault = std::get_if<ParseError>(&text)) {
    throw ProgramError(ProgramError::kUsage, "cannot read the level '" + path_.string() + "' (" + fault->what +
                                                 "); name a readable level file, or a new one");
  }
  text_ = std::get<std::string>(std::move(text));
  return text_;
}

std::optional<std::string> EditFile::save(const std::string& text) {
  if (const std::string fault = replaceTextFile(path_.string(), text); !fault.empty()) {
    return "cannot write '" + path_.string() + "': " + fault;
  }
  text_ = text;
  return std::nullopt;
}

std::optional<std::string> EditFile::takeChange() {
  auto text = readTextFile(path_.string(), kMaxLevelBytes);
  if (std::holds_alternative<ParseError>(text) || std::get<std::string>(text) == text_) return std::nullopt;
  text_ = std::get<std::string>(std::move(text));
  return text_;
}

std::optional<std::string> EditFile::pollChange(FileWatch::Time now) {
  return watch_.poll(now) ? takeChange() : std::nullopt;
}

}  // namespace platon
