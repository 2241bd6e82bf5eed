#include "tests/present/window/hands.h"

#include <array>
#include <stdexcept>
#include <string>

#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

namespace offing::test {

struct Hands::State {
  Display* display = nullptr;
  Window minimised = 0;

  void put(KeySym symbol, bool is_down) const {
    const KeyCode code = XKeysymToKeycode(display, symbol);
    if (code == 0) throw std::runtime_error("the keyboard has no such key");
    XTestFakeKeyEvent(display, code, is_down ? True : False, CurrentTime);
    XSync(display, False);
  }

  Window focused() const {
    Window window = 0;
    int revert = 0;
    XGetInputFocus(display, &window, &revert);
    return window;
  }

  /// As ICCCM 4.1.3.1 has it.
  void set_wm_state(Window window, long state) const {
    const Atom name = XInternAtom(display, "WM_STATE", False);
    const std::array<long, 2> values{state, None};
    XChangeProperty(display, window, name, name, 32, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(values.data()), 2);
  }
};

Hands::Hands() : state_(std::make_unique<State>()) {
  state_->display = XOpenDisplay(nullptr);
  int ignored = 0;
  if (state_->display == nullptr ||
      XTestQueryExtension(state_->display, &ignored, &ignored, &ignored, &ignored) == False) {
    throw std::runtime_error("the display server has no XTEST");
  }
  // How long a key is down depends on how long frames take.
  XAutoRepeatOff(state_->display);
}

Hands::~Hands() {
  if (state_->display != nullptr) XCloseDisplay(state_->display);
}

void Hands::key(std::string_view name, Motion motion) {
  const KeySym symbol = XStringToKeysym(std::string(name).c_str());
  state_->put(symbol, motion == Motion::down);
}

void Hands::press(std::string_view name) {
  key(name, Motion::down);
  key(name, Motion::up);
}

void Hands::type(std::string_view text) {
  for (const char character : text) {
    // Latin 1 characters are their own key symbols; those on a key's upper half need Shift.
    const auto symbol = static_cast<KeySym>(static_cast<unsigned char>(character));
    const KeyCode code = XKeysymToKeycode(state_->display, symbol);
    const bool is_upper = XkbKeycodeToKeysym(state_->display, code, 0, 0) != symbol;
    if (is_upper) key("Shift_L", Motion::down);
    state_->put(symbol, true);
    state_->put(symbol, false);
    if (is_upper) key("Shift_L", Motion::up);
  }
}

void Hands::move_to(int x, int y) {
  XTestFakeMotionEvent(state_->display, DefaultScreen(state_->display), x, y, CurrentTime);
  XSync(state_->display, False);
}

void Hands::button(Button button, Motion motion) {
  XTestFakeButtonEvent(state_->display, static_cast<unsigned>(button), motion == Motion::down ? True : False,
                       CurrentTime);
  XSync(state_->display, False);
}

bool Hands::has_window() const {
  const Window window = state_->focused();
  return window > PointerRoot && window != DefaultRootWindow(state_->display);
}

std::string Hands::title() const {
  // As the window's system shows it (EWMH, _NET_WM_NAME).
  const Atom name = XInternAtom(state_->display, "_NET_WM_NAME", False);
  constexpr long most_words = 256;
  Atom type = 0;
  int bits = 0;
  unsigned long count = 0, left = 0;
  unsigned char* text = nullptr;
  XGetWindowProperty(state_->display, state_->focused(), name, 0, most_words, False, AnyPropertyType, &type,
                     &bits, &count, &left, &text);
  std::string title = text == nullptr ? "" : std::string(reinterpret_cast<const char*>(text), count);
  if (text != nullptr) XFree(text);
  return title;
}

void Hands::close() {
  // As ICCCM 4.2.8.1 has it.
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = state_->focused();
  event.xclient.message_type = XInternAtom(state_->display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(state_->display, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(state_->display, event.xclient.window, False, NoEventMask, &event);
  XSync(state_->display, False);
}

std::vector<unsigned char> Hands::screen() const {
  const int number = DefaultScreen(state_->display);
  const auto width = static_cast<unsigned>(DisplayWidth(state_->display, number));
  const auto height = static_cast<unsigned>(DisplayHeight(state_->display, number));
  XImage* image =
      XGetImage(state_->display, DefaultRootWindow(state_->display), 0, 0, width, height, AllPlanes, ZPixmap);
  if (image == nullptr) throw std::runtime_error("the display server shows no screen");
  const std::size_t size = static_cast<std::size_t>(image->bytes_per_line) * height;
  const auto* bytes = reinterpret_cast<const unsigned char*>(image->data);
  std::vector<unsigned char> pixels(bytes, bytes + size);
  XDestroyImage(image);
  return pixels;
}

void Hands::minimise() {
  state_->minimised = state_->focused();
  state_->set_wm_state(state_->minimised, IconicState);
  XUnmapWindow(state_->display, state_->minimised);
  XSync(state_->display, False);
}

void Hands::restore() {
  state_->set_wm_state(state_->minimised, NormalState);
  XMapWindow(state_->display, state_->minimised);
  XSync(state_->display, False);
  XSetInputFocus(state_->display, state_->minimised, RevertToParent, CurrentTime);
  XSync(state_->display, False);
}

}  // namespace offing::test
