#include "client/replay/replay_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

#include "protocol/files/regular_file.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxHeadBytes = kMaxLevelBytes + 64;
constexpr std::size_t kPartBytes = std::size_t{1} << 20;  // that are read at a time

std::span<const std::uint8_t> bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

std::string unreadable(const std::string& reason) { return "cannot be read: " + reason; }

// At most one byte more than `maxBytes`. Returns why it failed, or an empty text.
std::string readParts(const Descriptor& file, std::size_t maxBytes, std::string& content, const std::stop_token& stop) {
  while (content.size() <= maxBytes) {
    if (stop.stop_requested()) return Replay::kStopped;
    const std::size_t before = content.size();
    const std::size_t part = std::min(kPartBytes, maxBytes + 1 - before);
    content.resize(before + part);
    const std::optional<std::size_t> read = readNext(file, content.data() + before, part);
    content.resize(before + read.value_or(0));
    if (!read) return unreadable(std::strerror(errno));
    if (*read < part) break;
  }
  return {};
}

// At most one byte more than `maxBytes`, and room for as many as the file has: it may be small.
RecordingBytes readFile(const fs::path& file, std::size_t maxBytes, const std::stop_token& stop) {
  const OpenedFile opened = openToRead(file.string());
  if (!opened.file) return {{}, unreadable(opened.fault)};
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(file, fault);
  const auto limit = fault ? maxBytes : static_cast<std::size_t>(std::min<std::uintmax_t>(size, maxBytes));
  RecordingBytes bytes;
  bytes.fault = readParts(opened.file, limit, bytes.content, stop);
  return bytes;
}

}  // namespace

std::span<const std::uint8_t> RecordingBytes::bytes() const { return bytesOf(content); }

RecordingBytes readRecordingBytes(const fs::path& file, const std::stop_token& stop) {
  RecordingBytes read = readFile(file, Replay::kMaxBytes, stop);
  if (read.content.size() > Replay::kMaxBytes) return {{}, "is larger than any recording that can be played"};
  return read;
}

std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const fs::path& file, const std::stop_token& stop,
                                                                    ReplayProgress* progress) {
  const RecordingBytes read = readRecordingBytes(file, stop);
  if (!read.fault.empty()) return file.string() + ": " + read.fault;
  auto replay = Replay::read(read.bytes(), stop, progress);
  if (const auto* fault = std::get_if<std::string>(&replay)) return file.string() + ": " + *fault;
  return replay;
}

std::optional<RecordingHead> readRecordingHeadOf(const fs::path& file, const std::stop_token& stop) {
  const RecordingBytes read = readFile(file, kMaxHeadBytes, stop);
  return read.fault.empty() ? readRecordingHead(read.bytes()) : std::nullopt;
}

}  // namespace platon
