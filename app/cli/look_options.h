// Options that pictures and the window share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/io/failure.h"
#include "app/io/png.h"
#include "app/pictures/look.h"

namespace pupflow::cli {

/// The options as typed.
struct LookOptions {
  std::string color_by = "tb";
  std::string colormap, scale;  // empty: the field's own
  std::string draw = std::string(view::name_of(pictures::Look{}.draw));
  std::string quality = std::string(view::name_of(pictures::Look{}.quality));
  std::string overlay;
  double trail = pictures::Look{}.trail;
  bool caption = false, celsius = false, transparent = false;
  int dpi = 0;
  std::string shader_dir;
  int supersample = 0;
  bool verbose = false;
  bool automatic = false;  // see add_look
};

/// Declares those that the window has, too. `automatic`: the colors span what is seen unless --scale is given, not the
/// field's range.
void add_look(CLI::App& verb, LookOptions& options, bool automatic);

/// Declares what is drawn over the litter: --overlay, --caption.
void add_overlays(CLI::App& verb, LookOptions& options);

/// Declares --trail.
void add_trail(CLI::App& verb, LookOptions& options);

/// Declares --overlay, --caption and what only pictures have.
void add_picture_look(CLI::App& verb, LookOptions& options);

/// Takes what was not typed from the entries of a picture.
void take_look(const CLI::App& verb, const io::TextEntries& picture, LookOptions& options);

/// `failure` where its option was typed; else in words that name the picture `like` that has the value.
io::Failure about_like(const CLI::App& verb, const std::string& like, const io::Failure& failure);

/// Refuses the name of a picture that ends as another kind of file does, e.g. a.jpg.
void check_picture_name(const std::string& option, const std::string& path);

/// Checks them. Throws Failure(bad_input).
pictures::Look look_of(const LookOptions& options);

/// The entry called `key`, or nullptr.
const std::string* find_entry(const io::TextEntries& entries, std::string_view key);

}  // namespace pupflow::cli
