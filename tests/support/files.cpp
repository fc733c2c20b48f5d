#include "tests/support/files.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace platon {
namespace {

template <class Content>
Content read(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  Content content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw std::runtime_error("cannot read '" + file.string() + "'");
  return content;
}

}  // namespace

std::string readText(const std::filesystem::path& file) { return read<std::string>(file); }

std::vector<std::uint8_t> readBytes(const std::filesystem::path& file) { return read<std::vector<std::uint8_t>>(file); }

void writeText(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text << std::flush)) throw std::runtime_error("cannot write '" + file.string() + "'");
}

std::vector<std::string> filesIn(const std::filesystem::path& folder, const std::string& extension) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == extension) found.push_back(entry.path());
  }
  if (found.empty()) throw std::runtime_error("no file " + folder.string() + "/**/*" + extension);
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return std::pair(a.filename(), a) < std::pair(b.filename(), b); });
  return {found.begin(), found.end()};
}

std::vector<std::string> shippedLevels() { return filesIn("levels", ".level"); }

std::vector<std::string> solidLevels() {
  std::vector<std::string> files;
  for (const char* solid : {"tetrahedron", "hexahedron", "octahedron", "dodecahedron", "icosahedron"}) {
    files.push_back(std::string("tests/determinism/golden/levels/") + solid + ".level");
  }
  return files;
}

}  // namespace platon
