#include "levels/tool/preview_command.h"

#include <cstdio>
#include <optional>

#include "levels/picture/level_picture.h"
#include "levels/tool/level_file.h"
#include "protocol/files/text_file.h"
#include "protocol/program_error.h"

namespace platon {

int previewLevel(const std::string& file, const std::string& picture, int width) {
  const std::optional<LevelResult> result = loadLevelFile(file);
  if (!result) return ProgramError::kUsage;
  if (!result->level) return ProgramError::kInvalid;
  const std::string fault = replaceOutputFile(picture, drawLevel(*result->level, width).png());
  if (fault.empty()) return 0;
  std::fprintf(stderr, "platon-level: cannot write '%s': %s\n", picture.c_str(), fault.c_str());
  return ProgramError::kFailed;
}

}  // namespace platon
