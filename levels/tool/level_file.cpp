#include "levels/tool/level_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "levels/check/level_warnings.h"
#include "protocol/files/text_file.h"

namespace platon {

std::optional<std::string> readInputFile(const std::string& path, std::size_t maxBytes, std::string& fault) {
  const OpenedFile opened = openToRead(path, Pipes::kRead);
  std::string content;
  if (opened.file && readUpTo(opened.file, maxBytes, content)) return content;
  const std::string reason = opened.file ? std::strerror(errno) : opened.fault;
  fault = "cannot read '" + path + "': " + reason + "; name a readable file";
  return std::nullopt;
}

namespace {

std::vector<std::string_view> linesOf(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

// The line of the text, and below it a caret at the column. Nothing for a line that cannot be shown.
std::string marked(const std::vector<std::string_view>& lines, const Diagnostic& diagnostic) {
  constexpr std::size_t longest = 200;
  const auto index = static_cast<std::size_t>(diagnostic.line) - 1;
  if (index >= lines.size() || lines[index].size() > longest || lines[index].empty()) return {};
  std::string shown(lines[index]);
  for (char& byte : shown) byte = byte >= ' ' && byte <= '~' ? byte : ' ';
  return "    " + shown + "\n    " + std::string(static_cast<std::size_t>(diagnostic.column) - 1, ' ') + "^\n";
}

}  // namespace

std::optional<LevelResult> loadLevelFile(const std::string& path, bool withAdvice) {
  std::string fault;
  const auto text = readInputFile(path, kMaxLevelBytes + 1, fault);
  if (!text) {
    std::fprintf(stderr, "platon-level: %s\n", fault.c_str());
    return std::nullopt;
  }
  LevelResult result = loadLevel(*text);
  if (withAdvice && result.level) {
    const std::vector<Diagnostic> advice = warningsOf(result.level);
    result.diagnostics.insert(result.diagnostics.end(), advice.begin(), advice.end());
    std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  }
  print(path, *text, result.diagnostics);
  return result;
}

void print(const std::string& path, std::string_view text, const std::vector<Diagnostic>& diagnostics) {
  const std::vector<std::string_view> lines = linesOf(text);
  for (const Diagnostic& diagnostic : diagnostics) {
    std::fprintf(stderr, "%s\n%s", format(path, diagnostic).c_str(), marked(lines, diagnostic).c_str());
  }
}

}  // namespace platon
