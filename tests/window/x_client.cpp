#include "tests/window/x_client.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>

#include <chrono>
#include <stdexcept>
#include <vector>

namespace pupflow::testing {
namespace {

constexpr std::chrono::seconds kPatience{60};

long number(Atom atom) {
  return static_cast<long>(atom);
}

}  // namespace

struct XClient::Impl {
  explicit Impl(const std::string& name) : display(XOpenDisplay(name.c_str())) {
    if (display == nullptr) throw std::runtime_error("no display " + name);
    own = XCreateSimpleWindow(display, root(), 0, 0, 1, 1, 0, 0, 0);
  }
  ~Impl() { XCloseDisplay(display); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Window root() const { return DefaultRootWindow(display); }
  Atom atom(const char* name) const { return XInternAtom(display, name, False); }

  std::vector<Window> visible_windows() const {
    Window top = 0, parent = 0;
    Window* windows = nullptr;
    unsigned count = 0;
    XQueryTree(display, root(), &top, &parent, &windows, &count);
    std::vector<Window> visible;
    for (unsigned i = 0; i < count; ++i) {
      XWindowAttributes attributes{};
      XGetWindowAttributes(display, windows[i], &attributes);
      if (attributes.map_state == IsViewable) visible.push_back(windows[i]);
    }
    if (windows != nullptr) XFree(windows);
    return visible;
  }

  bool tell(Window window, const char* type, const std::vector<long>& data) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    for (std::size_t i = 0; i < data.size(); ++i) event.xclient.data.l[i] = data[i];  // NOLINT
    const bool sent = XSendEvent(display, window, False, NoEventMask, &event) != 0;
    XFlush(display);
    return sent;
  }

  /// The next event of that type.
  XEvent await(int type, const char* what) const {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (std::chrono::steady_clock::now() < end) {
      if (XPending(display) == 0) {
        pollfd waiting{ConnectionNumber(display), POLLIN, 0};
        poll(&waiting, 1, 100);
        continue;
      }
      XEvent event{};
      XNextEvent(display, &event);
      if (event.type == type) return event;
    }
    throw std::runtime_error(std::string(what) + " never came");
  }

  Display* display;
  Window own;
  Window over = 0;
};

XClient::XClient(const std::string& display) : impl_(std::make_unique<Impl>(display)) {}
XClient::~XClient() = default;

bool XClient::close_windows() {
  bool asked = false;
  for (const Window window : impl_->visible_windows()) {
    asked |= impl_->tell(window, "WM_PROTOCOLS", {number(impl_->atom("WM_DELETE_WINDOW"))});
  }
  return asked;
}

void XClient::cover() {
  Display* const display = impl_->display;
  XSetWindowAttributes attributes{};
  attributes.override_redirect = True;
  const int screen = DefaultScreen(display);
  impl_->over = XCreateWindow(
      display, impl_->root(), 0, 0, static_cast<unsigned>(DisplayWidth(display, screen)),
      static_cast<unsigned>(DisplayHeight(display, screen)), 0, CopyFromParent, InputOutput,
      nullptr, CWOverrideRedirect, &attributes);
  XMapRaised(display, impl_->over);
  XFlush(display);
}

void XClient::uncover() {
  XDestroyWindow(impl_->display, impl_->over);
  XFlush(impl_->display);
}

void XClient::drop(const std::string& path) {
  constexpr long kVersion = 5L << 24;
  const std::vector<Window> windows = impl_->visible_windows();
  if (windows.empty()) throw std::runtime_error("no window to drop on");
  const Window target = windows.back();
  const long own = static_cast<long>(impl_->own);
  const Atom selection = impl_->atom("XdndSelection");
  XSetSelectionOwner(impl_->display, selection, impl_->own, CurrentTime);
  impl_->tell(target, "XdndEnter", {own, kVersion, number(impl_->atom("text/uri-list")), 0, 0});
  impl_->tell(target, "XdndPosition",
              {own, 0, (300L << 16) | 300L, 0, number(impl_->atom("XdndActionCopy"))});
  impl_->await(ClientMessage, "the answer to a file held over the window");
  impl_->tell(target, "XdndDrop", {own, 0, 0, 0, 0});

  const XSelectionRequestEvent asked =
      impl_->await(SelectionRequest, "the question for the dropped file").xselectionrequest;
  const std::string list = "file://" + path + "\r\n";
  XChangeProperty(impl_->display, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(list.data()),
                  static_cast<int>(list.size()));
  XEvent answer{};
  answer.xselection.type = SelectionNotify;
  answer.xselection.requestor = asked.requestor;
  answer.xselection.selection = asked.selection;
  answer.xselection.target = asked.target;
  answer.xselection.property = asked.property;
  answer.xselection.time = asked.time;
  XSendEvent(impl_->display, asked.requestor, False, NoEventMask, &answer);
  XFlush(impl_->display);
}

std::string XClient::clipboard() {
  Display* const display = impl_->display;
  const Atom text = impl_->atom("UTF8_STRING"), place = impl_->atom("PUPFLOW_TEST");
  XConvertSelection(display, impl_->atom("CLIPBOARD"), text, place, impl_->own, CurrentTime);
  XFlush(display);
  const XEvent answer = impl_->await(SelectionNotify, "the clipboard's text");
  if (answer.xselection.property == None) throw std::runtime_error("the clipboard is empty");
  Atom type = 0;
  int format = 0;
  unsigned long length = 0, left = 0;
  unsigned char* bytes = nullptr;
  XGetWindowProperty(display, impl_->own, place, 0, 1 << 16, True, AnyPropertyType, &type, &format,
                     &length, &left, &bytes);
  const std::string content(reinterpret_cast<const char*>(bytes), length);
  if (bytes != nullptr) XFree(bytes);
  return content;
}

unsigned long XClient::pixel(int x, int y) {
  XImage* const image = XGetImage(impl_->display, impl_->root(), x, y, 1, 1, AllPlanes, ZPixmap);
  if (image == nullptr) throw std::runtime_error("no such pixel");
  const unsigned long color = XGetPixel(image, 0, 0) & 0xffffff;
  XDestroyImage(image);
  return color;
}

}  // namespace pupflow::testing
