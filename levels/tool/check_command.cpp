#include "levels/tool/check_command.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

#include "levels/tool/json_text.h"
#include "levels/tool/level_file.h"
#include "platon/game/level.h"

namespace platon {
namespace {

constexpr int kCannotRead = 2;
constexpr int kInvalidLevel = 3;

struct Checked {
  std::string file;
  LevelResult result;
};

const char* severity(const Diagnostic& found) { return found.error ? "error" : "warning"; }

std::size_t errorsOf(const Checked& checked) {
  const auto& found = checked.result.diagnostics;
  return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [](const auto& one) { return one.error; }));
}

std::size_t linesOf(const Level& level) {
  std::size_t lines = 0;
  for (const auto& face : level.lines) lines += face.size();
  return lines;
}

void printDiagnostics(const Checked& checked) {
  for (const Diagnostic& found : checked.result.diagnostics) {
    std::fprintf(stderr, "%s\n", format(checked.file, found).c_str());
  }
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string verdict(const Checked& checked) {
  const std::size_t errors = errorsOf(checked);
  const std::size_t warnings = checked.result.diagnostics.size() - errors;
  const std::string tail = warnings == 0 ? "" : ", " + counted(warnings, "warning");
  if (checked.result.level == nullptr) return checked.file + ": " + counted(errors, "error") + tail;
  const Level& level = *checked.result.level;
  return checked.file + ": ok, " + std::string(nameOf(level.solid)) + ", " + counted(linesOf(level), "line") + tail;
}

std::string jsonOf(const Diagnostic& found) {
  return "{\"line\":" + std::to_string(found.line) + ",\"column\":" + std::to_string(found.column) +
         ",\"severity\":\"" + std::string(severity(found)) + "\",\"message\":" + jsonText(found.message) + "}";
}

std::string jsonOf(const Level& level) {
  return ",\"solid\":\"" + std::string(nameOf(level.solid)) + "\",\"faceSize\":" + std::to_string(level.faceSize) +
         ",\"lines\":" + std::to_string(linesOf(level)) + ",\"title\":" + jsonText(level.title) +
         ",\"author\":" + jsonText(level.author);
}

std::string jsonOf(const Checked& checked) {
  const LevelResult& result = checked.result;
  std::string json = "{\"file\":" + jsonText(checked.file) + ",\"ok\":" + (result.level ? "true" : "false");
  if (result.level) json += jsonOf(*result.level);
  json += ",\"diagnostics\":[";
  for (const Diagnostic& found : result.diagnostics) {
    if (&found != &result.diagnostics.front()) json += ",";
    json += jsonOf(found);
  }
  return json + "]}";
}

void printJson(const std::vector<Checked>& all) {
  std::string json = "{\"levels\":[";
  for (const Checked& checked : all) json += (&checked == &all.front() ? "" : ",") + jsonOf(checked);
  std::puts((json + "]}").c_str());
}

}  // namespace

int checkLevels(const std::vector<std::string>& files, bool json) {
  std::vector<Checked> all;
  bool unreadable = false;
  for (const std::string& file : files) {
    std::string fault;
    const auto text = readLevelFile(file, fault);
    if (!text) {
      std::fprintf(stderr, "platon-level: %s\n", fault.c_str());
      unreadable = true;
      continue;
    }
    all.push_back({file, loadLevel(*text)});
    printDiagnostics(all.back());
    if (!json) std::puts(verdict(all.back()).c_str());
  }
  if (json) printJson(all);
  if (unreadable) return kCannotRead;
  const bool good = std::all_of(all.begin(), all.end(), [](const Checked& one) { return one.result.level != nullptr; });
  return good ? 0 : kInvalidLevel;
}

}  // namespace platon
