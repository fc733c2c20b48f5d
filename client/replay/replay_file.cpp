#include "client/replay/replay_file.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "protocol/files/text_file.h"

namespace platon {
namespace {

constexpr std::size_t kMaxHeadBytes = kMaxLevelBytes + 64;

std::span<const std::uint8_t> bytesOf(const std::string& content) {
  return {reinterpret_cast<const std::uint8_t*>(content.data()), content.size()};
}

// At most so many bytes, and room for as many as the file has: it may be small.
std::variant<std::string, ParseError> readFile(const std::filesystem::path& file, std::size_t maxBytes) {
  std::error_code fault;
  const std::uintmax_t size = std::filesystem::file_size(file, fault);
  return readTextFile(file.string(),
                      fault ? maxBytes : static_cast<std::size_t>(std::min<std::uintmax_t>(size, maxBytes)));
}

}  // namespace

std::span<const std::uint8_t> RecordingBytes::bytes() const { return bytesOf(content); }

RecordingBytes readRecordingBytes(const std::filesystem::path& file) {
  auto read = readFile(file, Replay::kMaxBytes);
  if (const auto* error = std::get_if<ParseError>(&read)) return {{}, "cannot be read: " + error->what};
  RecordingBytes bytes{std::get<std::string>(std::move(read)), {}};
  if (bytes.content.size() > Replay::kMaxBytes) return {{}, "is larger than any recording that can be played"};
  return bytes;
}

std::variant<std::shared_ptr<const Replay>, std::string> readReplay(const std::filesystem::path& file,
                                                                    const std::stop_token& stop) {
  const RecordingBytes read = readRecordingBytes(file);
  if (!read.fault.empty()) return file.string() + ": " + read.fault;
  auto replay = Replay::read(read.bytes(), stop);
  if (const auto* fault = std::get_if<std::string>(&replay)) return file.string() + ": " + *fault;
  return replay;
}

std::optional<RecordingHead> readRecordingHeadOf(const std::filesystem::path& file) {
  const auto read = readFile(file, kMaxHeadBytes);
  const auto* const content = std::get_if<std::string>(&read);
  return content == nullptr ? std::nullopt : readRecordingHead(bytesOf(*content));
}

}  // namespace platon
