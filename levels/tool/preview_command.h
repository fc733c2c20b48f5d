#pragma once

#include <string>

namespace platon {

/// Draws a level file as a PNG file, so many pixels wide. Prints every error and warning of the level to stderr, as
/// checkLevels does. Returns the exit code: 0, 1 when the picture cannot be written, 2 when the level file cannot be
/// read, 3 when the level has an error.
int previewLevel(const std::string& file, const std::string& picture, int width);

}  // namespace platon
