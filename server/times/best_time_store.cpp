#include "server/times/best_time_store.h"

#include <filesystem>
#include <utility>

#include "platon/game/game.h"
#include "protocol/files/private_file.h"
#include "protocol/files/text_file.h"

namespace platon {
namespace {

constexpr const char* kRemedy = "; name a file that can be read and written, in a folder that exists";

}  // namespace

std::variant<BestTimes, std::vector<std::string>> readBestTimes(const std::string& path) {
  const std::filesystem::path file(path);
  std::error_code fault;
  const bool missing = std::filesystem::status(file, fault).type() == std::filesystem::file_type::not_found;
  const bool hasFolder = !file.has_parent_path() || std::filesystem::is_directory(file.parent_path(), fault);
  if (missing && hasFolder) return BestTimes();
  auto text = readTextFile(path, BestTimes::kMaxBytes);
  if (const auto* error = std::get_if<ParseError>(&text)) {
    return std::vector{path + ": error: " + error->what + kRemedy};
  }
  auto parsed = BestTimes::parse(std::get<std::string>(text));
  if (auto* times = std::get_if<BestTimes>(&parsed)) return std::move(*times);
  std::vector<std::string> errors;
  for (const Diagnostic& one : std::get<std::vector<Diagnostic>>(parsed)) errors.push_back(format(path, one));
  return errors;
}

// Another program may add times meanwhile. There are file systems without locks, where one of the two is lost then.
std::string addBestTimes(const std::string& path, std::string_view text) {
  const OpenedFile lock = lockBeside(path, WithoutLocks::kGoOn);
  auto read = readBestTimes(path);
  if (const auto* errors = std::get_if<std::vector<std::string>>(&read)) return errors->front();
  if (!lock.file) return path + ": error: " + lock.fault;
  BestTimes& times = std::get<BestTimes>(read);
  times.merge(std::get<BestTimes>(BestTimes::parse(text)));
  return replaceTextFile(path, times.text());
}

BestTimeStore::BestTimeStore(Clock clock, const std::string& path, BestTimes times)
    : clock_(std::move(clock)),
      times_(std::move(times)),
      kept_(times_),
      file_(std::make_unique<FileWriter>(path, startThread, addBestTimes)) {}

std::optional<BestTime> BestTimeStore::best(std::uint64_t level) const {
  const DatedTime* best = times_.find({level, kRulesVersion});
  return best ? std::optional(best->time) : std::nullopt;
}

bool BestTimeStore::offer(std::uint64_t level, const BestTime& time, bool lasts) {
  const PlayedLevel played{level, kRulesVersion};
  const DatedTime dated{time, clock_()};
  const bool isBest = times_.offer(played, dated);
  if (!file_ || !lasts || !kept_.offer(played, dated)) return isBest;
  if (!file_->pending()) unwritten_ = BestTimes();
  unwritten_.offer(played, dated);
  file_->write(unwritten_.text());
  return isBest;
}

std::optional<std::string> BestTimeStore::poll(FileWriter::Time now) { return file_ ? file_->poll(now) : std::nullopt; }

}  // namespace platon
