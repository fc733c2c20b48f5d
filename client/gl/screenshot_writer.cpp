#include "client/gl/screenshot_writer.h"

#include <cstdio>
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

ScreenshotWriter::~ScreenshotWriter() {
  while (writing_.isPending()) take(writing_.wait());
}

void ScreenshotWriter::write(Image image) {
  if (waiting_.size() == kMaxWaiting) {
    report_ = notSaved("too many at once");
    return;
  }
  waiting_.push_back(std::make_shared<const Image>(std::move(image)));
  if (!writing_.isPending()) startNext();
}

void ScreenshotWriter::startNext() {
  if (waiting_.empty()) return;
  writing_ = Job<std::string>([folder = folder_, image = std::move(waiting_.front())](
                                  const std::stop_token&) { return writeTo(folder, *image); },
                              start_);
  waiting_.pop_front();
}

void ScreenshotWriter::take(JobResult<std::string> written) {
  report_ = written.value ? std::move(*written.value) : notSaved(written.fault);
  startNext();
}

std::optional<std::string> ScreenshotWriter::takeReport() {
  if (auto written = writing_.poll()) take(std::move(*written));
  return std::exchange(report_, std::nullopt);
}

}  // namespace platon
