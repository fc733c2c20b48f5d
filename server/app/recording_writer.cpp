#include "server/app/recording_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "platon/game/game.h"
#include "protocol/files/text_file.h"
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

bool isDigit(char c) { return c >= '0' && c <= '9'; }

// Removes as many characters from the front as satisfy `condition`, and returns their number.
template <class Condition>
std::size_t skipAll(std::string_view& text, Condition condition) {
  const auto end = std::find_if_not(text.begin(), text.end(), condition);
  const auto length = static_cast<std::size_t>(end - text.begin());
  text.remove_prefix(length);
  return length;
}

bool skip(std::string_view& text, std::string_view expected) {
  if (!text.starts_with(expected)) return false;
  text.remove_prefix(expected.size());
  return true;
}

struct Recording {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
};

// The recordings in a folder, oldest first. What cannot be read is left out.
std::vector<Recording> recordingsIn(const std::filesystem::path& folder) {
  std::vector<Recording> found;
  std::error_code error;
  for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end; file.increment(error)) {
    std::error_code unreadable;
    if (!isRecordingName(file->path().filename().string()) || !file->is_regular_file(unreadable)) continue;
    const std::uint64_t bytes = file->file_size(unreadable);
    if (!unreadable && !file->is_symlink(unreadable)) found.push_back({file->path(), bytes});
  }
  std::stable_sort(found.begin(), found.end(), [](const Recording& a, const Recording& b) { return a.path < b.path; });
  return found;
}

// False also if a server is writing the file, which it has locked.
bool removeFile(const std::filesystem::path& path) {
  const OpenedFile opened = openToRead(path.string());
  if (!opened.file) return false;
  const bool locked = flock(opened.file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return !locked && unlink(path.c_str()) == 0;
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

bool isRecordingName(std::string_view file) {
  const bool time = skipAll(file, isDigit) == 8 && skip(file, "T") && skipAll(file, isDigit) == 6 && skip(file, "Z");
  if (!time || !skip(file, "-round-") || skipAll(file, isDigit) < 4) return false;
  skipAll(file, [](char c) { return isDigit(c) || (c >= 'a' && c <= 'z') || c == '-'; });
  return file == kEnding;
}

RecordingFolder::RecordingFolder(std::filesystem::path folder, std::uint64_t limit)
    : folder_(std::move(folder)), limit_(limit) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) refuse(folder_, "the folder cannot be created: " + error.message());
  std::string trial = folder_ / ".platon-trial-XXXXXX";
  const Descriptor file(mkostemp(trial.data(), O_CLOEXEC));
  if (!file) refuse(folder_, std::strerror(errno));
  unlink(trial.c_str());
}

void RecordingFolder::write(const RecordingPiece& piece, Time now, std::vector<RecordingEvent>& events) {
  using Kind = RecordingEvent::Kind;
  const bool begins = round_ != piece.round;
  if (!begins && !file_) return;  // an earlier piece could not be written
  if (begins) begin(piece, now);
  const auto stop = [&](const std::string& reason) {
    events.push_back({Kind::kStopped, path_.string(), 0, 0, reason});
    discardRest();
  };
  if (!makeRoom(piece.bytes.size(), events)) {
    return stop("the limit of " + std::to_string(limit_) + " bytes for recordings is reached; raise --record-limit");
  }
  if ((begins && !open()) || !append(piece)) return stop(std::strerror(errno));
  if (!piece.last) return;
  file_.reset();
  events.push_back({Kind::kFinished, path_.string(), piece.ticks, bytes_, ""});
}

// A round is named after its beginning. Its first piece comes some seconds later.
void RecordingFolder::begin(const RecordingPiece& piece, Time now) {
  file_.reset();
  round_ = piece.round;
  bytes_ = 0;
  known_.reset();
  path_ = folder_ /
          (recordingName(now - std::chrono::seconds(piece.ticks / kTicksPerSecond), round_, piece.title) + kEnding);
}

// Never overwrites a file: another server may have started a round with this number in the same second.
bool RecordingFolder::open() {
  const std::filesystem::path stem = path_.parent_path() / path_.stem();
  file_.reset(std::fopen(path_.c_str(), "wbxe"));
  for (int copy = 2; !file_ && errno == EEXIST; ++copy) {
    path_ = stem.string() + "-" + std::to_string(copy) + kEnding;
    file_.reset(std::fopen(path_.c_str(), "wbxe"));
  }
  if (!file_) return false;
  // Without a buffer nothing is lost when the program is killed, and nothing is written after a failure.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
  flock(fileno(file_.get()), LOCK_EX | LOCK_NB);
  return true;
}

bool RecordingFolder::append(const RecordingPiece& piece) {
  if (std::fwrite(piece.bytes.data(), 1, piece.bytes.size(), file_.get()) != piece.bytes.size()) return false;
  bytes_ += piece.bytes.size();
  return true;
}

// Closes the file without a piece of which only a part was written, so that it is valid up to there. Without any whole
// piece nothing is left of it.
void RecordingFolder::discardRest() {
  if (!file_) return;
  const bool cut = ftruncate(fileno(file_.get()), static_cast<off_t>(bytes_)) == 0;
  file_.reset();
  std::error_code error;
  if (!cut || bytes_ == 0) std::filesystem::remove(path_, error);
}

// Other servers may have written since the last search.
bool RecordingFolder::isKnownToFit(std::uint64_t bytes) const {
  return known_ && bytes_ + bytes - searchedAt_ <= spare() && *known_ + bytes_ + bytes <= limit_;
}

// Removes old recordings until there is room for more bytes of the file. Returns whether there is.
bool RecordingFolder::makeRoom(std::uint64_t bytes, std::vector<RecordingEvent>& events) {
  if (isKnownToFit(bytes)) return true;
  std::vector<Recording> others = recordingsIn(folder_);
  std::erase_if(others, [this](const Recording& other) { return file_ && other.path == path_; });
  searchedAt_ = bytes_;
  known_ = 0;
  for (const Recording& other : others) *known_ += other.bytes;
  // Removes a little more than is needed, so that the folder is not searched for every piece.
  const std::uint64_t wanted = *known_ + bytes_ + bytes > limit_ ? limit_ - spare() : limit_;
  for (const Recording& other : others) {
    if (*known_ + bytes_ + bytes <= wanted) break;
    if (!removeFile(other.path)) continue;
    *known_ -= other.bytes;
    events.push_back({RecordingEvent::Kind::kRemoved, other.path.string(), 0, other.bytes, ""});
  }
  return *known_ + bytes_ + bytes <= limit_;
}

RecordingWriter::RecordingWriter(Write write)
    : write_(std::make_shared<const Write>(std::move(write))), writing_(startThread, std::chrono::milliseconds(0)) {}

void RecordingWriter::write(RecordingPiece piece, Time now) {
  takeWritten();
  if (dropped_ == piece.round) return;
  if (bytes_ + piece.bytes.size() > kQueueBytes) return stop(piece.round, "the disk is too slow");
  bytes_ += piece.bytes.size();
  const auto shared = std::make_shared<const RecordingPiece>(std::move(piece));
  queue_.push_back({shared->round, shared->bytes.size()});
  writing_.add([write = write_, shared, now](const std::stop_token&) {
    Events events;
    (*write)(*shared, now, events);
    return events;
  });
}

void RecordingWriter::takeWritten() {
  for (auto written = writing_.poll(); written; written = writing_.take()) {
    const Queued piece = queue_.front();
    queue_.pop_front();
    bytes_ -= piece.bytes;
    if (written->value)
      events_.insert(events_.end(), written->value->begin(), written->value->end());
    else
      stop(piece.round, std::move(written->fault));
  }
}

void RecordingWriter::stop(std::uint32_t round, std::string reason) {
  dropped_ = round;
  events_.push_back({RecordingEvent::Kind::kStopped, "", 0, 0, std::move(reason)});
}

RecordingWriter::Events RecordingWriter::takeEvents() {
  takeWritten();
  return std::exchange(events_, {});
}

}  // namespace platon
