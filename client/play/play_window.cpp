#include "client/play/play_window.h"

#include <stdexcept>

#include "protocol/program_error.h"

namespace platon {

Window openWindow(const std::string& otherwise) {
  try {
    return {"Platon", static_cast<int>(kPictureWidth), static_cast<int>(kPictureHeight)};
  } catch (const std::runtime_error& error) {
    throw ProgramError(ProgramError::kUsage, error.what() + ("; " + otherwise));
  }
}

void showLoading(Window& window, GameView& view) {
  view.draw(nullptr, {.message = "Loading …"}, Settings(), Overlay(), 0);
  view.present();
  window.show();
}

}  // namespace platon
