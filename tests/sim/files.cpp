#include "tests/sim/files.h"

#include <cerrno>
#include <cstring>

#include "protocol/files/text_file.h"
#include "tests/sim/sim_options.h"

namespace platon::sim {

std::vector<std::uint8_t> readBytes(const std::string& path, std::size_t maxBytes) {
  const OpenedFile opened = openToRead(path, Pipes::kRead);
  std::vector<std::uint8_t> bytes;
  if (opened.file && readUpTo(opened.file, maxBytes, bytes)) return bytes;
  const std::string reason = opened.file ? std::strerror(errno) : opened.fault;
  throw UsageError("cannot read '" + path + "': " + reason + "; name a readable file");
}

OutputFile::OutputFile(const std::string& path, Mode mode) : path_(path) {
  std::string fault;
  if (mode == Mode::kReplace) {
    fault = replacement_.emplace(path).fault();
  } else {
    file_.reset(std::fopen(path.c_str(), mode == Mode::kCreateNew ? "wbx" : "wb"));
    if (!file_) fault = std::strerror(errno);
  }
  if (!fault.empty()) throw UsageError("cannot write '" + path + "': " + fault);
}

void OutputFile::write(const void* bytes, std::size_t count) {
  if (replacement_) {
    replacement_->write({static_cast<const char*>(bytes), count});
    if (!replacement_->fault().empty()) fail(replacement_->fault());
  } else if (std::fwrite(bytes, 1, count, file_.get()) != count) {
    fail(std::strerror(errno));
  }
}

void OutputFile::close() {
  if (replacement_) {
    if (const std::string fault = replacement_->finish(); !fault.empty()) fail(fault);
  } else if (std::fflush(file_.get()) != 0) {
    fail(std::strerror(errno));
  }
}

void OutputFile::fail(const std::string& reason) const {
  throw InputError("cannot write to '" + path_ + "': " + reason);
}

}  // namespace platon::sim
