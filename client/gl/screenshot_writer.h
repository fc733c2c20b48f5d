#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "client/gl/image.h"
#include "protocol/work/worker.h"

namespace platon {

/// Writes pictures into a folder as `platon-0001.png` and so on: a thread writes them, one after the other, so that the
/// game goes on meanwhile.
class ScreenshotWriter {
 public:
  /// Most pictures that wait to be written.
  static constexpr std::size_t kMaxWaiting = 4;

  /// The folder is made when it is needed; an empty path: the working directory.
  explicit ScreenshotWriter(std::filesystem::path folder, ThreadStart start = &startThread)
      : folder_(std::move(folder)), writing_(std::move(start)) {}
  /// Waits until all pictures are written, for at most Worker::kEndTime.
  ~ScreenshotWriter() { writing_.finish(); }
  ScreenshotWriter(const ScreenshotWriter&) = delete;
  ScreenshotWriter& operator=(const ScreenshotWriter&) = delete;

  /// Starts to write a picture, after those before. If kMaxWaiting pictures wait, it is dropped, and a report says so.
  void write(Image image);
  /// Goes on with the next picture. Call now and then. Returns what became of the last picture, a sentence for the
  /// player, once.
  std::optional<std::string> takeReport();

 private:
  std::filesystem::path folder_;
  std::optional<std::string> report_;
  Worker<std::string> writing_;  // what to report
};

}  // namespace platon
