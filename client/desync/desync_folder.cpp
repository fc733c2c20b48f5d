#include "client/desync/desync_folder.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

namespace platon {

namespace {

// A new file only: nothing that is there is written over. 0 or the error.
template <class Bytes>
int write(const std::filesystem::path& path, const Bytes& bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) return errno;
  const bool whole = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int error = whole ? 0 : errno;
  return std::fclose(file) == 0 ? error : errno;
}

std::string notKept(const std::filesystem::path& path, int error) {
  return "; the report could not be written to " + path.string() + ": " + std::strerror(error);
}

}  // namespace

std::string DesyncFolder::keep(const DesyncReport& report) const {
  if (folder_.empty()) return report.summary;
  std::error_code ignored;  // opening finds out
  std::filesystem::create_directories(folder_, ignored);
  for (int number = 1; number <= kMaxReports; ++number) {
    const std::string name = "desync-" + std::to_string(number);
    const std::filesystem::path text = folder_ / (name + ".txt");
    const std::filesystem::path recording = folder_ / (name + ".recording");
    // The number is free when neither is there. The recording comes first, so that no text names another's.
    if (std::filesystem::exists(text, ignored)) continue;
    const int error = write(recording, report.recording);
    if (error == EEXIST) continue;
    if (error != 0) return report.summary + notKept(recording, error);
    const int textError = write(text, report.text + "\nRecording of the own game: " + recording.string() + "\n");
    return report.summary + (textError == 0 ? "; see " + text.string() : notKept(text, textError));
  }
  return report.summary + "; not written, for " + folder_.string() + " has " + std::to_string(kMaxReports) +
         " reports already: remove those that are no longer needed";
}

}  // namespace platon
