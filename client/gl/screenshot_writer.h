#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "client/gl/image.h"

namespace platon {

/// Writes pictures into a folder as `platon-0001.png` and so on, each by a thread, so that the game goes on meanwhile.
class ScreenshotWriter {
 public:
  /// The folder is made when it is needed; an empty path: the working directory.
  explicit ScreenshotWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Waits until the last picture is written.
  ~ScreenshotWriter();
  ScreenshotWriter(const ScreenshotWriter&) = delete;
  ScreenshotWriter& operator=(const ScreenshotWriter&) = delete;

  /// Starts to write a picture. Waits for the one before.
  void write(Image image);
  /// What became of the last picture, a sentence for the player; each is returned once.
  std::optional<std::string> takeReport();

 private:
  std::string writeNow(const Image& image) const;
  void finish();

  std::filesystem::path folder_;
  std::thread thread_;
  std::mutex mutex_;
  std::optional<std::string> report_;
};

}  // namespace platon
