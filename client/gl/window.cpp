#include "client/gl/window.h"

#include <stdexcept>
#include <utility>

#include <GL/glew.h>
#include <GLFW/glfw3.h>

#include "client/gl/gl_loader.h"

namespace platon {
namespace {

constexpr float kDeadZone = 0.4F;

std::string lastFault() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words != nullptr ? words : "no reason given";
}

GLFWwindow* openWindow(const std::string& title, int width, int height) {
  if (glfwInit() != GLFW_TRUE) throw std::runtime_error("no window can be opened: " + lastFault());
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  GLFWwindow* handle = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (handle == nullptr) {
    const std::string fault = lastFault();
    glfwTerminate();
    throw std::runtime_error("no window can be opened: " + fault);
  }
  return handle;
}

}  // namespace

Window::Window(const std::string& title, int width, int height) : handle_(openWindow(title, width, height)) {
  glfwSetWindowUserPointer(handle_, this);
  glfwSetKeyCallback(handle_, onKey);
  glfwMakeContextCurrent(handle_);
  glfwSwapInterval(1);
  try {
    loadOpenGl();
  } catch (...) {
    glfwTerminate();
    throw;
  }
  poll();
}

Window::~Window() {
  glfwDestroyWindow(handle_);
  glfwTerminate();
}

void Window::poll() {
  glfwPollEvents();
  const auto down = [this](int key) { return glfwGetKey(handle_, key) == GLFW_PRESS; };
  held_.left = down(GLFW_KEY_LEFT) || down(GLFW_KEY_A);
  held_.right = down(GLFW_KEY_RIGHT) || down(GLFW_KEY_D);
  held_.up = down(GLFW_KEY_UP) || down(GLFW_KEY_W);
  held_.down = down(GLFW_KEY_DOWN) || down(GLFW_KEY_S);
  held_.jump = down(GLFW_KEY_SPACE);
  held_.restart = down(GLFW_KEY_R);
  pollGamepads();
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(handle_, &width, &height);
  pixelWidth_ = static_cast<std::uint32_t>(width);
  pixelHeight_ = static_cast<std::uint32_t>(height);
}

bool Window::closing() const { return glfwWindowShouldClose(handle_) == GLFW_TRUE; }

std::vector<Window::Press> Window::takePresses() { return std::exchange(presses_, {}); }

void Window::setFullscreen(bool fullscreen) {
  const bool isFullscreen = glfwGetWindowMonitor(handle_) != nullptr;
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  if (fullscreen == isFullscreen || monitor == nullptr) return;
  if (fullscreen) {
    glfwGetWindowPos(handle_, &windowed_[0], &windowed_[1]);
    glfwGetWindowSize(handle_, &windowed_[2], &windowed_[3]);
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  } else {
    glfwSetWindowMonitor(handle_, nullptr, windowed_[0], windowed_[1], windowed_[2], windowed_[3], GLFW_DONT_CARE);
  }
  glfwSwapInterval(1);
}

void Window::show() { glfwSwapBuffers(handle_); }

void Window::onKey(GLFWwindow* handle, int key, int /*scancode*/, int action, int mods) {
  if (action == GLFW_RELEASE) return;
  auto& presses = static_cast<Window*>(glfwGetWindowUserPointer(handle))->presses_;
  switch (key) {
    case GLFW_KEY_ESCAPE:
      presses.push_back(Press::kMenu);
      break;
    case GLFW_KEY_UP:
    case GLFW_KEY_W:
      presses.push_back(Press::kUp);
      break;
    case GLFW_KEY_DOWN:
    case GLFW_KEY_S:
      presses.push_back(Press::kDown);
      break;
    case GLFW_KEY_LEFT:
    case GLFW_KEY_A:
      presses.push_back(Press::kLeft);
      break;
    case GLFW_KEY_RIGHT:
    case GLFW_KEY_D:
      presses.push_back(Press::kRight);
      break;
    case GLFW_KEY_ENTER:
      presses.push_back((mods & GLFW_MOD_ALT) != 0 ? Press::kFullscreen : Press::kChoose);
      break;
    case GLFW_KEY_SPACE:
      presses.push_back(Press::kChoose);
      break;
    case GLFW_KEY_F1:
      presses.push_back(Press::kHelp);
      break;
    case GLFW_KEY_F3:
      presses.push_back(Press::kNetGraph);
      break;
    case GLFW_KEY_F11:
      presses.push_back(Press::kFullscreen);
      break;
    default:
      break;
  }
}

void Window::pollGamepads() {
  Buttons now;
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    GLFWgamepadstate state;
    if (glfwJoystickIsGamepad(joystick) != GLFW_TRUE || glfwGetGamepadState(joystick, &state) != GLFW_TRUE) continue;
    const auto down = [&state](int button) { return state.buttons[button] == GLFW_PRESS; };
    const float x = state.axes[GLFW_GAMEPAD_AXIS_LEFT_X];
    const float y = state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y];
    now.left |= down(GLFW_GAMEPAD_BUTTON_DPAD_LEFT) || x < -kDeadZone;
    now.right |= down(GLFW_GAMEPAD_BUTTON_DPAD_RIGHT) || x > kDeadZone;
    now.up |= down(GLFW_GAMEPAD_BUTTON_DPAD_UP) || y < -kDeadZone;
    now.down |= down(GLFW_GAMEPAD_BUTTON_DPAD_DOWN) || y > kDeadZone;
    now.choose |= down(GLFW_GAMEPAD_BUTTON_A);
    now.menu |= down(GLFW_GAMEPAD_BUTTON_START);
    held_.restart |= down(GLFW_GAMEPAD_BUTTON_BACK);
  }
  held_.left |= now.left;
  held_.right |= now.right;
  held_.down |= now.down;
  held_.jump |= now.choose;
  press(now.menu, gamepad_.menu, Press::kMenu);
  press(now.choose, gamepad_.choose, Press::kChoose);
  press(now.up, gamepad_.up, Press::kUp);
  press(now.down, gamepad_.down, Press::kDown);
  press(now.left, gamepad_.left, Press::kLeft);
  press(now.right, gamepad_.right, Press::kRight);
  gamepad_ = now;
}

void Window::press(bool now, bool before, Press what) {
  if (now && !before) presses_.push_back(what);
}

}  // namespace platon
