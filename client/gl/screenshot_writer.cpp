#include "client/gl/screenshot_writer.h"

#include <cstdio>
#include <memory>
#include <system_error>

namespace platon {
namespace {

constexpr int kMaxFiles = 9999;

// The first name that no file has; empty if there is none.
std::filesystem::path freeName(const std::filesystem::path& folder) {
  for (int number = 1; number <= kMaxFiles; ++number) {
    char name[32];
    std::snprintf(name, sizeof name, "platon-%04d.png", number);
    std::error_code ignored;
    if (!std::filesystem::exists(folder / name, ignored)) return folder / name;
  }
  return {};
}

std::string notSaved(const std::string& reason) { return "the picture was not saved: " + reason; }

// Returns what to report.
std::string writeTo(const std::filesystem::path& folder, const Image& image) {
  std::error_code ignored;  // writing reports the error
  std::filesystem::create_directories(folder, ignored);
  const std::filesystem::path file = freeName(folder);
  writePng(image, file.string());
  return "picture saved: " + file.string();
}

}  // namespace

void ScreenshotWriter::write(Image image) {
  if (writing_.pending() > kMaxWaiting) {
    report_ = notSaved("too many at once");
    return;
  }
  writing_.add([folder = folder_, shared = std::make_shared<const Image>(std::move(image))](const std::stop_token&) {
    return writeTo(folder, *shared);
  });
}

std::optional<std::string> ScreenshotWriter::takeReport() {
  if (auto written = writing_.poll()) report_ = written->value ? std::move(*written->value) : notSaved(written->fault);
  return std::exchange(report_, std::nullopt);
}

}  // namespace platon
