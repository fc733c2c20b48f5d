#include "tests/sim/files.h"

#include <cerrno>
#include <cstring>

#include "protocol/files/regular_file.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t maxBytes) {
  const OpenedFile opened = openToRead(path, Pipes::kRead);
  std::vector<std::uint8_t> bytes;
  if (opened.file && readUpTo(opened.file, maxBytes, bytes)) return bytes;
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
