#include "app/context/headless.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include "app/gl/load.h"
#include "app/io/failure.h"
#include "app/io/memory.h"

namespace pupflow::context {

namespace {

std::string egl_error() {
  static constexpr std::array<std::string_view, 15> kNames{
      "EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
      "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
      "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
      "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
      "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
  const auto index = static_cast<std::size_t>(eglGetError() - EGL_SUCCESS);
  return std::string(index < kNames.size() ? kNames[index] : "unknown EGL error");
}

bool has_extension(EGLDisplay display, std::string_view name) {
  const char* all = eglQueryString(display, EGL_EXTENSIONS);
  return all != nullptr &&
         (" " + std::string(all) + " ").find(" " + std::string(name) + " ") != std::string::npos;
}

[[noreturn]] void fail(const std::string& what) {
  throw io::Failure(io::ExitCode::no_context, what);
}

/// An initialised display. EGL knows one by that name however often it is asked for, so the last of
/// its users terminates it.
class Display {
 public:
  /// Throws Failure(no_context).
  explicit Display(EGLDisplay display) : display_(display) {
    if (display_ == EGL_NO_DISPLAY) fail("no such display");
    const std::lock_guard lock(mutex());
    if (eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) fail(egl_error());
    ++users()[display_];
  }
  ~Display() {
    const std::lock_guard lock(mutex());
    if (--users()[display_] > 0) return;
    users().erase(display_);
    eglTerminate(display_);
  }
  Display(const Display&) = delete;
  Display& operator=(const Display&) = delete;

 private:
  // Never destroyed: contexts may outlive other globals.
  static std::mutex& mutex() {
    static auto* const shared = new std::mutex;
    return *shared;
  }
  static std::map<EGLDisplay, int>& users() {
    static auto* const shared = new std::map<EGLDisplay, int>;
    return *shared;
  }

  EGLDisplay display_;
};

/// A context without any surface on an EGL display.
class EglContext final : public Context {
 public:
  /// Throws Failure(no_context) with the step that failed.
  EglContext(std::string name, EGLDisplay display)
      : name_(std::move(name)), shared_(display), display_(display) {
    try {
      create();
    } catch (...) {
      release();
      throw;
    }
  }
  ~EglContext() override { release(); }

  void make_current() override {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      fail("cannot make the context current: " + egl_error());
    }
  }
  void release_current() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  std::string name() const override { return name_; }

 private:
  void create() {
    for (const char* needed : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
      if (!has_extension(display_, needed)) fail(std::string("lacks ") + needed);
    }
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) fail("has no OpenGL: " + egl_error());
    constexpr EGLint kAttributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                      3,
                                      EGL_CONTEXT_MINOR_VERSION,
                                      3,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                      EGL_NONE};
    context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 3.3 core: " + egl_error());
    make_current();
    gl::load_functions();
  }

  void release() {
    release_current();
    if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
    eglReleaseThread();
  }

  std::string name_;
  Display shared_;
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

/// One place where a context may be had.
struct Attempt {
  std::string name;
  std::function<EGLDisplay()> open;
};

std::vector<Attempt> attempts() {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto query_devices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::vector<Attempt> list;
  const auto add_platform = [&](std::string name, EGLenum platform, void* native) {
    list.push_back({std::move(name), [=] {
                      return get_display == nullptr ? EGL_NO_DISPLAY
                                                    : get_display(platform, native, nullptr);
                    }});
  };
  add_platform("EGL surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query_devices != nullptr) {
    query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count);
  }
  for (EGLint i = 0; i < count; ++i) {
    add_platform("EGL device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT,
                 devices[static_cast<std::size_t>(i)]);
  }
  list.push_back({"EGL default display", [] { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }});
  return list;
}

/// The first attempt that works, or nothing; every outcome goes to `report`.
std::unique_ptr<Context> try_all(ContextReport& report) {
  for (const Attempt& attempt : attempts()) {
    try {
      auto context = std::make_unique<EglContext>(attempt.name, attempt.open());
      report.works = true;
      report.chosen = attempt.name;
      report.renderer = gl::renderer_name();
      report.version = gl::version_text();
      report.tried.push_back(attempt.name + ": works");
      return context;
    } catch (const io::Failure& failure) {
      report.tried.push_back(attempt.name + ": " + failure.what());
    }
  }
  return nullptr;
}

/// Software drivers crash where they get no memory.
void refuse_small_address_space() {
  // Mesa's: its libraries, its compiler, and the stack of each of its threads.
  constexpr std::uint64_t kDriver = 400'000'000, kThread = 16'000'000;
  const std::uint64_t needed = kDriver + kThread * std::thread::hardware_concurrency();
  const std::uint64_t left = io::address_space_left();
  if (left >= needed) return;
  fail("OpenGL drivers need about " + std::to_string(needed / 1'000'000) +
       " MB of address space, and ulimit -v leaves " + std::to_string(left / 1'000'000) +
       " MB; raise it");
}

}  // namespace

std::unique_ptr<Context> make_headless(ContextReport& report) {
  report = {};
  refuse_small_address_space();
  auto context = try_all(report);
  if (context != nullptr) return context;
  std::string tried;
  for (const std::string& line : report.tried) tried += (tried.empty() ? "" : "; ") + line;
  fail("no OpenGL 3.3 context could be made without a display; tried " + tried +
       "; install libegl1 and libgl1-mesa-dri");
}

ContextReport probe_headless() {
  ContextReport report;
  try_all(report);
  return report;
}

}  // namespace pupflow::context
