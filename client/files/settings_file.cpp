#include "client/files/settings_file.h"

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "protocol/files/text_file.h"

namespace platon {

namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

std::string replaceWithFolder(const std::string& path, std::string_view content) {
  std::error_code ignored;  // writing reports the error
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  return replaceTextFile(path, content);
}

// Copies what the file held before it is replaced for the first time. One thread at a time calls it.
FileWriter::Replace replaceAfterCopy(std::string broken, const std::string& copy) {
  const auto uncopied = std::make_shared<std::optional<std::string>>(std::move(broken));
  return [uncopied, copy](const std::string& path, std::string_view content) {
    if (*uncopied) {
      const std::string fault = replaceWithFolder(copy, **uncopied);
      if (!fault.empty()) return "the old file cannot be kept as " + copy + ": " + fault;
      uncopied->reset();
    }
    return replaceWithFolder(path, content);
  };
}

}  // namespace

SettingsFile::SettingsFile(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  path_ = folder / "settings";
  writer_.emplace(path_.string(), startThread, replaceWithFolder);
}

Settings SettingsFile::load() {
  std::error_code ignored;  // reading reports the error
  if (!std::filesystem::exists(std::filesystem::symlink_status(path_, ignored))) return {};
  auto read = readTextFile(path_.string(), kMaxBytes);
  std::string* const text = std::get_if<std::string>(&read);
  if (text == nullptr)
    return refuse("cannot be read: " + std::get<ParseError>(read).what + "; make it readable or remove it");
  if (text->size() > kMaxBytes) return refuse("is larger than 1 MiB; shorten or remove it");
  SettingsResult result = parseSettings(*text);
  for (const std::string& error : result.errors) {
    std::fprintf(stderr, "platon-client: %s: %s\n", path_.c_str(), error.c_str());
  }
  // Each unknown line has an error, too.
  if (const std::size_t invalid = result.errors.size() - result.unknownLines.size(); invalid != 0) {
    fault_ = (invalid == 1 ? "1 line" : std::to_string(invalid) + " lines") + " of " + path_.string() +
             (invalid == 1 ? " is" : " are") + " invalid; the next save keeps the old file as " + brokenPath();
    if (writer_) writer_.emplace(path_.string(), startThread, replaceAfterCopy(*text, brokenPath()));
  }
  unknownLines_ = std::move(result.unknownLines);
  return result.settings;
}

Settings SettingsFile::refuse(const std::string& reason) {
  fault_ = path_.string() + " " + reason + "; the settings are not saved";
  std::fprintf(stderr, "platon-client: %s\n", fault_.c_str());
  writer_.reset();
  return {};
}

std::string SettingsFile::brokenPath() const { return path_.string() + ".broken"; }

std::string SettingsFile::textOf(const Settings& settings) const {
  std::string text = settings.text();
  for (const std::string& line : unknownLines_) text += line + "\n";
  return text;
}

void SettingsFile::update(const Settings& settings, Time now) {
  if (!writer_) return;
  if (now >= lookAt_) look(settings, now);
  report(writer_->poll(FileWriter::Time(now)));
}

void SettingsFile::look(const Settings& settings, Time now) {
  lookAt_ = now + kLookInterval;
  std::string text = textOf(settings);
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
  saved_ = textOf(settings);
  writer_->write(*saved_);
  report(writer_->finish());
}

void SettingsFile::report(const std::optional<std::string>& fault) const {
  if (!fault) return;
  std::fprintf(stderr, "platon-client: cannot write %s: %s; the settings are not saved\n", path_.c_str(),
               fault->c_str());
}

}  // namespace platon
