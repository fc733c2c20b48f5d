#include "client/files/settings_file.h"

#include <cstddef>
#include <cstdio>
#include <string_view>
#include <utility>
#include <variant>

#include "protocol/files/private_file.h"
#include "protocol/files/text_file.h"
#include "protocol/texts.h"

namespace platon {

namespace {

KeptFile keptAt(const std::filesystem::path& path) { return {path, std::size_t{1} << 20}; }

std::string brokenOf(const std::string& path) { return path + ".broken"; }

// Each unknown line has an error, too.
std::size_t invalidLines(const SettingsResult& result) { return result.errors.size() - result.unknownLines.size(); }

std::string writeSettings(const std::string& path, std::string_view settings) {
  const auto replace = [&](const std::string& kept) -> std::variant<std::string, ParseError> {
    const SettingsResult before = parseSettings(kept);
    if (invalidLines(before) != 0) {
      const std::string fault = replaceTextFile(brokenOf(path), kept);
      if (!fault.empty()) return ParseError{"the old file cannot be kept as " + brokenOf(path) + ": " + fault};
    }
    std::string text(settings);
    for (const std::string& line : before.unknownLines) text += line + "\n";
    return text;
  };
  return keptAt(path).change(replace);
}

}  // namespace

SettingsFile::SettingsFile(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  path_ = folder / "settings";
  writer_.emplace(path_.string(), startThread, writeSettings);
}

Settings SettingsFile::load() {
  const auto read = keptAt(path_).read();
  if (const auto* error = std::get_if<ParseError>(&read)) {
    fault_ = path_.string() + " cannot be read: " + error->what + "; the settings are not saved";
    std::fprintf(stderr, "platon-client: %s\n", fault_.c_str());
    writer_.reset();
    return {};
  }
  SettingsResult result = parseSettings(std::get<std::string>(read));
  for (const std::string& error : result.errors) {
    std::fprintf(stderr, "platon-client: %s: %s\n", path_.c_str(), error.c_str());
  }
  if (const std::size_t invalid = invalidLines(result); invalid != 0) {
    fault_ = counted(invalid, "line") + " of " + path_.string() + (invalid == 1 ? " is" : " are") +
             " invalid; the next save keeps the old file as " + brokenOf(path_.string());
  }
  return result.settings;
}

void SettingsFile::update(const Settings& settings, Time now) {
  if (!writer_) return;
  if (now >= lookAt_) look(settings, now);
  report(writer_->poll(FileWriter::Time(now)));
}

void SettingsFile::look(const Settings& settings, Time now) {
  lookAt_ = now + kLookInterval;
  std::string text = settings.text();
  if (!saved_) saved_ = text;
  if (text != text_) {
    text_ = std::move(text);
    changedAt_ = now;
  }
  if (text_ == *saved_ || now - changedAt_ < kCalmTime) return;
  saved_ = text_;
  writer_->write(*saved_);
}

void SettingsFile::save(const Settings& settings) {
  if (!writer_) return;
  saved_ = settings.text();
  writer_->write(*saved_);
  report(writer_->finish());
}

void SettingsFile::report(const std::optional<std::string>& fault) const {
  if (!fault) return;
  std::fprintf(stderr, "platon-client: cannot write %s: %s; the settings are not saved\n", path_.c_str(),
               fault->c_str());
}

}  // namespace platon
