#include "levels/tool/check_command.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <utility>

#include "levels/check/level_warnings.h"
#include "levels/tool/level_file.h"
#include "platon/game/level.h"
#include "protocol/program_error.h"
#include "protocol/texts.h"

namespace platon {
namespace {

struct CheckedLevel {
  std::string file;
  LevelResult result;
};

const char* severity(const Diagnostic& diagnostic) { return diagnostic.error ? "error" : "warning"; }

std::size_t errorsOf(const CheckedLevel& checked) {
  const auto& all = checked.result.diagnostics;
  return static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const auto& one) { return one.error; }));
}

std::string resultLine(const CheckedLevel& checked) {
  const std::size_t errors = errorsOf(checked);
  const std::size_t warnings = checked.result.diagnostics.size() - errors;
  const std::string tail = warnings == 0 ? "" : ", " + counted(warnings, "warning");
  if (checked.result.level == nullptr) return checked.file + ": " + counted(errors, "error") + tail;
  const Level& level = *checked.result.level;
  return checked.file + ": ok, " + std::string(nameOf(level.solid)) + ", " + counted(lineCount(level), "line") + tail;
}

std::string jsonOf(const Diagnostic& diagnostic) {
  return "{\"line\":" + std::to_string(diagnostic.line) + ",\"column\":" + std::to_string(diagnostic.column) +
         ",\"severity\":\"" + std::string(severity(diagnostic)) + "\",\"message\":" + jsonText(diagnostic.message) +
         "}";
}

std::string jsonOf(const Level& level) {
  return ",\"solid\":\"" + std::string(nameOf(level.solid)) + "\",\"faceSize\":" + std::to_string(level.faceSize) +
         ",\"lines\":" + std::to_string(lineCount(level)) + ",\"title\":" + jsonText(level.title) +
         ",\"author\":" + jsonText(level.author);
}

std::string jsonOf(const CheckedLevel& checked) {
  const LevelResult& result = checked.result;
  std::string json = "{\"file\":" + jsonText(checked.file) + ",\"ok\":" + (result.level ? "true" : "false");
  if (result.level) json += jsonOf(*result.level);
  json += ",\"diagnostics\":[";
  for (const Diagnostic& diagnostic : result.diagnostics) {
    if (&diagnostic != &result.diagnostics.front()) json += ",";
    json += jsonOf(diagnostic);
  }
  return json + "]}";
}

void printJson(const std::vector<CheckedLevel>& all) {
  std::string json = "{\"levels\":[";
  for (const CheckedLevel& checked : all) json += (&checked == &all.front() ? "" : ",") + jsonOf(checked);
  std::puts((json + "]}").c_str());
}

}  // namespace

int checkLevels(const std::vector<std::string>& files, bool json) {
  std::vector<CheckedLevel> all;
  bool unreadable = false;
  for (const std::string& file : files) {
    std::optional<LevelResult> result = loadLevelFile(file, true);
    if (!result) {
      unreadable = true;
      continue;
    }
    all.push_back({file, std::move(*result)});
    if (!json) std::puts(resultLine(all.back()).c_str());
  }
  if (json) printJson(all);
  if (unreadable) return ProgramError::kUsage;
  const bool valid = std::all_of(all.begin(), all.end(), [](const auto& one) { return one.result.level != nullptr; });
  return valid ? 0 : ProgramError::kInvalid;
}

}  // namespace platon
