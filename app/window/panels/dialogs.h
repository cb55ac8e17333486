// Questions in front of the window: which file, and whether to keep changes.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "app/window/file_list.h"
#include "app/window/panels/panel.h"

namespace pupflow::window {

/// One dialog at a time. While one is shown, it has the keyboard.
class Dialogs {
 public:
  struct Answer {
    enum class Kind { open, save_as, save, discard };
    Kind kind;
    std::string path;  // of a file to open, or to save as
  };

  /// Asks for a file to open, or for one to save as (`name` is offered), first in `folder`.
  void ask_open(const std::string& folder);
  void ask_save(const std::string& folder, const std::string& name);

  /// Asks what to do with the changes of `scene` before `next`, e.g. "quitting".
  void ask_keep(const std::string& scene, const std::string& next);

  bool shown() const { return shown_ != Shown::none; }

  void cancel() { shown_ = Shown::none; }

  /// As if its first button had been pressed.
  void accept() { accepted_ = true; }

  /// Shows in the dialog that asked for a file why that one cannot be taken.
  void refuse(const std::string& reason);

  /// Draws the dialog. What was answered closes it.
  std::optional<Answer> draw(const PanelInput& in);

 private:
  enum class Shown { none, open, save, keep };

  void begin_file(Shown shown, const std::string& folder, const std::string& name);
  void set_name(const std::string& name);
  void go_to(const std::string& folder);
  std::optional<Answer> draw_file(const PanelInput& in);
  std::optional<Answer> draw_keep(const PanelInput& in);
  bool draw_list(const PanelInput& in, float height);
  std::optional<Answer> take_name();

  Shown shown_ = Shown::none;
  bool fresh_ = false, accepted_ = false;  // not drawn yet; see accept
  FileList list_;
  std::array<char, 4096> name_{};  // typed or picked
  std::string problem_;            // why it cannot be taken
  std::string scene_, next_;
};

}  // namespace pupflow::window
