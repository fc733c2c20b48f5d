#include "levels/tool/level_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace platon {

std::optional<std::string> readLevelFile(const std::string& path, std::string& fault) {
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  const std::unique_ptr<std::FILE, Close> file(std::fopen(path.c_str(), "rb"));
  std::string content;
  if (file != nullptr) {
    content.resize(kMaxLevelBytes + 1);
    content.resize(std::fread(content.data(), 1, content.size(), file.get()));
  }
  if (file != nullptr && std::ferror(file.get()) == 0) return content;
  fault = "cannot read '" + path + "': " + std::strerror(errno);
  return std::nullopt;
}

std::optional<LevelResult> loadLevelFile(const std::string& path) {
  std::string fault;
  const auto text = readLevelFile(path, fault);
  if (!text) {
    std::fprintf(stderr, "platon-level: %s\n", fault.c_str());
    return std::nullopt;
  }
  LevelResult result = loadLevel(*text);
  for (const Diagnostic& diagnostic : result.diagnostics) {
    std::fprintf(stderr, "%s\n", format(path, diagnostic).c_str());
  }
  return result;
}

}  // namespace platon
