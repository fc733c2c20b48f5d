#include "client/play/play_window.h"

#include <algorithm>
#include <stdexcept>

#include "client/gl/gl_loader.h"
#include "protocol/program_error.h"

namespace platon {

Moment frameTimeOf(bool calm, double frameCap) {
  if (calm) return kCalmFrameTime;
  return frameCap < 1 ? kMinFrameTime : std::max(kMinFrameTime, Moment(static_cast<Moment::rep>(1e6 / frameCap)));
}

Window openWindow(const std::string& otherwise) {
  try {
    return {"Platon", static_cast<int>(kPictureWidth), static_cast<int>(kPictureHeight)};
  } catch (const NoOpenGl& error) {
    throw ProgramError(ProgramError::kFailed, error.what());
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
