#include "client/files/settings_file.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "protocol/files/text_file.h"

namespace platon {

namespace {

std::string replaceWithFolder(const std::string& path, std::string_view content) {
  std::error_code ignored;  // writing reports the error
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  return replaceTextFile(path, content);
}

}  // namespace

SettingsFile::SettingsFile(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  path_ = folder / "settings";
  writer_.emplace(path_.string(), FileWriter::startThread, replaceWithFolder);
}

Settings SettingsFile::load() {
  std::ifstream file(path_, std::ios::binary);
  if (!file) return {};
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  SettingsResult result = parseSettings(text);
  for (const std::string& error : result.errors) {
    std::fprintf(stderr, "platon-client: %s: %s\n", path_.c_str(), error.c_str());
  }
  unknownLines_ = std::move(result.unknownLines);
  return result.settings;
}

std::string SettingsFile::textOf(const Settings& settings) const {
  std::string text = settings.text();
  for (const std::string& line : unknownLines_) text += line + "\n";
  return text;
}

void SettingsFile::update(const Settings& settings, Moment now) {
  if (!writer_) return;
  if (now >= lookAt_) look(settings, now);
  report(writer_->poll(FileWriter::Time(now)));
}

void SettingsFile::look(const Settings& settings, Moment now) {
  lookAt_ = now + kLookInterval;
  std::string text = textOf(settings);
  if (!saved_) saved_ = text;
  if (text != text_) {
    text_ = std::move(text);
    changedAt_ = now;
  }
  if (text_ == *saved_ || now - changedAt_ < kCalmTime) return;
  saved_ = text_;
  writer_->write(text_);
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
