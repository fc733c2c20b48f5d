#include "tests/sim/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "tests/sim/sim_options.h"

namespace platon::sim {

std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t maxBytes) {
  const auto close = [](std::FILE* file) { std::fclose(file); };
  const std::unique_ptr<std::FILE, decltype(close)> file(std::fopen(path.c_str(), "rb"), close);
  std::vector<std::uint8_t> bytes;
  for (std::size_t got = 1; file != nullptr && got != 0;) {
    const std::size_t had = bytes.size();
    bytes.resize(std::min(maxBytes, had + (std::size_t{1} << 16)));
    got = std::fread(bytes.data() + had, 1, bytes.size() - had, file.get());
    bytes.resize(had + got);
  }
  if (file != nullptr && std::ferror(file.get()) == 0) return bytes;
  throw UsageError("cannot read '" + path + "': " + std::strerror(errno));
}

OutputFile::OutputFile(const std::string& path, Mode mode)
    : path_(path), file_(std::fopen(path.c_str(), mode == Mode::kCreateNew ? "wbx" : "wb")) {
  if (!file_) throw UsageError("cannot write '" + path + "': " + std::strerror(errno));
}

void OutputFile::write(const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, file_.get()) != count) fail();
}

void OutputFile::close() {
  if (std::fflush(file_.get()) != 0) fail();
}

void OutputFile::fail() const { throw InputError("cannot write to '" + path_ + "': " + std::strerror(errno)); }

}  // namespace platon::sim
