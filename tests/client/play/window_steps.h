#pragma once

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "client/gl/window.h"
#include "client/play/screen.h"
#include "client/time/steady_now.h"

namespace platon {

/// One step of a test in a window: does something once, then waits until a condition holds.
struct WindowStep {
  std::function<void()> act;
  std::function<bool()> until;
};

inline bool windowHas(int attribute) { return glfwGetWindowAttrib(glfwGetCurrentContext(), attribute) == GLFW_TRUE; }

/// Shows screens, as the program does, until all steps are done, the screens end by themselves, or for `seconds`. The
/// first step begins when the window has the focus. Returns whether all steps were done, and else the number of the
/// step that was not, from 1 on; 0: the window never had the focus.
inline testing::AssertionResult runSteps(ScreenStack& screens, Window& window, double seconds,
                                         std::vector<WindowStep> steps) {
  steps.insert(steps.begin(), {[] {}, [] { return windowHas(GLFW_FOCUSED); }});
  const Clock clock = steadyClock();
  const Time start = clock.now();
  std::size_t next = 0;
  bool acted = false;
  Time before = start;
  for (Time now = start; screens.isOpen() && next < steps.size(); now = clock.now()) {
    if (toSeconds(now - start) >= seconds) break;
    const Frame frame{now, toSeconds(now - std::exchange(before, now))};
    window.poll();
    for (const WindowEvent& event : window.takeEvents()) screens.handle(event);
    screens.update(frame);
    if (!window.minimised()) {
      screens.draw(frame);
      window.show();
    }
    clock.sleepUntil(now + screens.frameTime());
    if (!std::exchange(acted, true)) steps[next].act();
    if (!steps[next].until()) continue;
    ++next;
    acted = false;
  }
  screens.close();
  if (next == steps.size()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the program ended at step " << next << " of " << steps.size() - 1;
}

}  // namespace platon
