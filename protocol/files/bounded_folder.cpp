#include "protocol/files/bounded_folder.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace platon {
namespace {

namespace fs = std::filesystem;

template <class Iterator>
std::vector<DatedFile> filesIn(const fs::path& folder, const std::function<bool(const fs::path&)>& belongs) {
  std::vector<DatedFile> files;
  std::error_code fault;
  for (Iterator entry(folder, fs::directory_options::skip_permission_denied, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    std::error_code unreadable;
    if (!belongs(entry->path()) || !entry->is_regular_file(unreadable)) continue;
    DatedFile file{entry->path(), entry->file_size(unreadable), {}};
    if (!unreadable) file.date = entry->last_write_time(unreadable);
    if (!unreadable) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

std::vector<DatedFile> newestFiles(const fs::path& folder, Subfolders subfolders,
                                   const std::function<bool(const fs::path&)>& belongs) {
  std::vector<DatedFile> files = subfolders == Subfolders::kWith
                                     ? filesIn<fs::recursive_directory_iterator>(folder, belongs)
                                     : filesIn<fs::directory_iterator>(folder, belongs);
  std::sort(files.begin(), files.end(), [](const DatedFile& a, const DatedFile& b) {
    return a.date != b.date ? a.date > b.date : a.path < b.path;
  });
  return files;
}

void removeOldest(const std::vector<DatedFile>& newestFirst, std::size_t maxFiles, std::uint64_t maxBytes) {
  std::size_t count = 0;
  std::uint64_t bytes = 0;
  std::error_code ignored;
  for (const DatedFile& file : newestFirst) {
    bytes += file.bytes;
    if (++count > maxFiles || bytes > maxBytes) fs::remove(file.path, ignored);
  }
}

}  // namespace platon
