#include "server/app/recording_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>

#include "protocol/program_error.h"

namespace platon {
namespace {

constexpr std::size_t kLongestSlug = 40;
const std::string kEnding = ".recording";

// The letters and digits of a title in lower case, with a dash for every run of other characters.
std::string slugOf(const std::string& title) {
  std::string slug;
  for (const char c : title) {
    const char low = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    const bool plain = (low >= 'a' && low <= 'z') || (low >= '0' && low <= '9');
    if (plain && slug.size() < kLongestSlug)
      slug += low;
    else if (!slug.empty() && slug.back() != '-')
      slug += '-';
  }
  if (!slug.empty() && slug.back() == '-') slug.pop_back();
  return slug;
}

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& why) {
  throw ProgramError(ProgramError::kUsage, "cannot write recordings to '" + folder.string() + "': " + why +
                                               "; name another folder after --record");
}

}  // namespace

std::string recordingName(RecordingFolder::Time start, std::uint32_t round, const std::string& title) {
  const std::string slug = slugOf(title);
  return fmt::format("{:%Y%m%dT%H%M%SZ}-round-{:04}{}", fmt::gmtime(std::chrono::system_clock::to_time_t(start)), round,
                     slug.empty() ? "" : "-" + slug);
}

RecordingFolder::RecordingFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) refuse(folder_, error.message());
  const std::filesystem::path trial = folder_ / ".platon-trial";
  const std::unique_ptr<std::FILE, Close> file(std::fopen(trial.c_str(), "wb"));
  if (!file) refuse(folder_, std::strerror(errno));
  std::filesystem::remove(trial, error);
}

void RecordingFolder::write(const RecordingPiece& piece, Time now, Log& log) {
  if (round_ != piece.round)
    open(piece, now);
  else if (!file_)
    return;  // an earlier piece could not be written
  if (!file_ || !append(piece)) {
    const std::string reason = std::strerror(errno);
    log.warning("recording stopped", {{"file", path_.string()}, {"reason", reason}});
    file_.reset();
  } else if (piece.last) {
    file_.reset();
    log.info("recording finished",
             {{"file", path_.string()}, {"ticks", std::uint64_t{piece.ticks}}, {"bytes", bytes_}});
  }
}

// Never overwrites a file: another server may have started a round with this number in the same second.
void RecordingFolder::open(const RecordingPiece& piece, Time now) {
  round_ = piece.round;
  bytes_ = 0;
  const std::string name = recordingName(now, round_, piece.title);
  path_ = folder_ / (name + kEnding);
  file_.reset(std::fopen(path_.c_str(), "wbx"));
  for (int copy = 2; !file_ && errno == EEXIST; ++copy) {
    path_ = folder_ / (name + "-" + std::to_string(copy) + kEnding);
    file_.reset(std::fopen(path_.c_str(), "wbx"));
  }
}

// Flushes at once, so that nothing is lost when the program is killed.
bool RecordingFolder::append(const RecordingPiece& piece) {
  bytes_ += piece.bytes.size();
  return std::fwrite(piece.bytes.data(), 1, piece.bytes.size(), file_.get()) == piece.bytes.size() &&
         std::fflush(file_.get()) == 0;
}

}  // namespace platon
