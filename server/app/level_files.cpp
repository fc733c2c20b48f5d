#include "server/app/level_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "platon/game/diagnostics.h"
#include "platon/game/level.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"
#include "protocol/texts.h"

namespace platon {
namespace {

namespace fs = std::filesystem;

// Most errors and warnings reported of one file: a file with thousands would flood the log.
constexpr std::size_t kMaxDiagnosticsPerFile = 100;

std::string readLevel(const std::string& path) {
  auto text = readTextFile(path, kMaxLevelBytes);
  if (auto* content = std::get_if<std::string>(&text)) return std::move(*content);
  throw ProgramError(ProgramError::kUsage, "cannot read the level '" + path + "': " + std::get<ParseError>(text).what +
                                               "; name a readable level file");
}

std::vector<std::string> levelFilesIn(const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code fault;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, fault)) {
    if (entry.path().extension() == ".level") files.push_back(entry.path().string());
  }
  // There is a folder for each solid. The order is that of the file names, which begin with a number.
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(a.filename(), a) < std::pair(b.filename(), b);
  });
  return files;
}

void report(const std::string& path, std::vector<Diagnostic> diagnostics, std::vector<std::string>& lines) {
  const std::size_t reported = std::min(diagnostics.size(), kMaxDiagnosticsPerFile);
  const std::size_t dropped = diagnostics.size() - reported;
  // Drops warnings before errors.
  if (dropped > 0)
    std::stable_partition(diagnostics.begin(), diagnostics.end(), [](const auto& one) { return one.error; });
  for (std::size_t i = 0; i < reported; ++i) lines.push_back(format(path, diagnostics[i]));
  if (dropped == 0) return;
  lines.push_back(path + ": " + std::to_string(dropped) + " more errors and warnings: platon-level check lists all");
}

}  // namespace

LoadedLevels loadLevelFiles(const std::vector<std::string>& paths) {
  LoadedLevels loaded;
  bool valid = true;
  for (const std::string& path : paths) {
    const LevelResult result = loadLevel(readLevel(path));
    report(path, result.diagnostics, loaded.warnings);
    valid = valid && result.level;
    loaded.levels.push_back(result.level);
  }
  if (!valid) throw ProgramError(ProgramError::kInvalid, joined(loaded.warnings, "\n"));
  return loaded;
}

std::vector<std::string> shippedLevelFiles(const std::string& otherwise) {
  std::error_code fault;
  const fs::path program = fs::read_symlink("/proc/self/exe", fault).parent_path();
  for (const fs::path& folder : {program / "../share/platon/levels", fs::path(PLATON_LEVELS)}) {
    std::vector<std::string> files = levelFilesIn(folder.lexically_normal());
    if (!files.empty()) return files;
  }
  throw ProgramError(ProgramError::kUsage, "cannot find the levels of the game, neither in '" +
                                               (program / "../share/platon/levels").lexically_normal().string() +
                                               "' nor in '" + PLATON_LEVELS + "'; " + otherwise);
}

}  // namespace platon
