#include "tests/sim/files.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

#include "protocol/files/regular_file.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t maxBytes) {
  const OpenedFile opened = openToRead(path, Pipes::kRead);
  std::vector<std::uint8_t> bytes;
  std::optional<std::size_t> got = opened.file ? std::optional<std::size_t>(1) : std::nullopt;
  while (got && *got != 0) {
    const std::size_t had = bytes.size();
    bytes.resize(std::min(maxBytes, had + (std::size_t{1} << 16)));
    got = readNext(opened.file, bytes.data() + had, bytes.size() - had);
    bytes.resize(had + got.value_or(0));
  }
  if (got) return bytes;
  const std::string reason = opened.file ? std::strerror(errno) : opened.fault;
  throw UsageError("cannot read '" + path + "': " + reason + "; name a readable file");
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
