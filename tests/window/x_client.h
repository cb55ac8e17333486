// Another program on the test's display: it drops files, reads the clipboard, covers windows.
#pragma once

#include <memory>
#include <string>

namespace pupflow::testing {

class XClient {
 public:
  /// `display` as ":7". Throws std::runtime_error when it cannot be reached.
  explicit XClient(const std::string& display);
  ~XClient();
  XClient(const XClient&) = delete;
  XClient& operator=(const XClient&) = delete;

  /// Asks every visible window to close, as a window manager's button does; false without one.
  bool close_windows();

  /// Lays a window over all others until `uncover`.
  void cover();
  void uncover();

  /// Drops a file on the visible window (XDND), and waits until it was taken. Throws
  /// std::runtime_error when it is not.
  void drop(const std::string& path);

  /// The text in the clipboard; throws std::runtime_error when nobody gives any.
  std::string clipboard();

  /// The color of a pixel as 0xRRGGBB.
  unsigned long pixel(int x, int y);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pupflow::testing
