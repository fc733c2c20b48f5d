#include "tests/protocol/documented_bytes.h"

#include <fstream>
#include <sstream>

namespace platon {

std::map<std::string, Bytes> documentedBytes() {
  std::ifstream page("docs/protocol.md");
  std::map<std::string, Bytes> blocks;
  std::string name;
  for (std::string line; std::getline(page, line);) {
    const std::string fence = "```";
    if (line.starts_with(fence)) {
      name = line.starts_with(fence + "bytes ") ? line.substr(fence.size() + 6) : "";
      continue;
    }
    if (name.empty()) continue;
    std::istringstream words(line.substr(0, line.find('#')));
    for (unsigned byte = 0; words >> std::hex >> byte;) blocks[name].push_back(static_cast<std::uint8_t>(byte));
  }
  return blocks;
}

}  // namespace platon
