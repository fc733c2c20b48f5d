#include "client/desync/desync_folder.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

namespace platon {

namespace {

// Creates a file with its whole content or not at all; never overwrites one. Returns 0 or the error number.
template <class Bytes>
int createFile(const std::filesystem::path& path, const Bytes& bytes) {
  std::FILE* const file = std::fopen(path.c_str(), "wbx");
  if (file == nullptr) return errno;
  int error = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
  if (std::fclose(file) != 0 && error == 0) error = errno;
  std::error_code ignored;
  if (error != 0) std::filesystem::remove(path, ignored);
  return error;
}

std::string failure(const std::filesystem::path& path, int error) {
  return "; cannot write " + path.string() + ": " + std::strerror(error);
}

}  // namespace

std::string DesyncFolder::write(const DesyncReport& report) const {
  if (folder_.empty()) return report.summary;
  std::error_code ignored;  // createFile reports the error
  std::filesystem::create_directories(folder_, ignored);
  for (int number = 1; number <= kMaxReports; ++number) {
    const std::string name = "desync-" + std::to_string(number);
    const std::filesystem::path text = folder_ / (name + ".txt");
    const std::filesystem::path recording = folder_ / (name + ".recording");
    // Both files must be new. The recording is created first, so that no text names the recording of another report.
    if (std::filesystem::exists(text, ignored)) continue;
    const int error = createFile(recording, report.recording);
    if (error == EEXIST) continue;
    if (error != 0) return report.summary + failure(recording, error);
    const int textError =
        createFile(text, report.text + "\nRecording of the client's game: " + recording.string() + "\n");
    return report.summary + (textError == 0 ? "; see " + text.string() : failure(text, textError));
  }
  return report.summary + "; not written: " + folder_.string() + " already has " + std::to_string(kMaxReports) +
         " reports; remove those you do not need";
}

}  // namespace platon
