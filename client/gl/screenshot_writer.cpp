#include "client/gl/screenshot_writer.h"

#include <cstdio>
#include <stdexcept>
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

}  // namespace

ScreenshotWriter::~ScreenshotWriter() { finish(); }

void ScreenshotWriter::finish() {
  if (thread_.joinable()) thread_.join();
}

void ScreenshotWriter::write(Image image) {
  finish();
  thread_ = std::thread([this, image = std::move(image)] {
    std::string report = writeNow(image);
    const std::lock_guard lock(mutex_);
    report_ = std::move(report);
  });
}

std::string ScreenshotWriter::writeNow(const Image& image) const {
  std::error_code ignored;  // writing reports the error
  std::filesystem::create_directories(folder_, ignored);
  const std::filesystem::path file = freeName(folder_);
  try {
    writePng(image, file.string());
  } catch (const std::runtime_error& error) {
    return std::string("the picture was not saved: ") + error.what();
  }
  return "picture saved: " + file.string();
}

std::optional<std::string> ScreenshotWriter::takeReport() {
  const std::lock_guard lock(mutex_);
  return std::exchange(report_, std::nullopt);
}

}  // namespace platon
