// Recordings in forms that other programs read.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "app/io/progress.h"
#include "app/io/recorded_run.h"

namespace pupflow::exporting {

struct Range {
  double low, high;
};

/// What a user asks for.
struct Request {
  std::string out;
  bool force = false;
  std::string field;           // empty: the format's own choice
  std::optional<int> pup;      // one of all
  bool sheet = false;          // afferents as images of the skin
  std::optional<Range> scale;  // of gcal: what becomes 0 and 1
};

/// A form that other programs read.
struct Format {
  std::string_view name;
  std::string_view doc;  // who reads it, and what it is
  void (*write)(const io::RecordedRun&, const Request&, io::Progress&);
};

/// All of them.
std::span<const Format> formats();

/// Writes `recording` in the form called `format`. Throws io::Failure.
void export_recording(const io::RecordedRun& recording, std::string_view format,
                      const Request& request, io::Progress& progress);

// One file each. npy.cpp: an array, or an image a frame where `out` has a place for a number.
void write_npy(const io::RecordedRun& recording, const Request& request, io::Progress& progress);
// timedarray.cpp
void write_timedarray(const io::RecordedRun& recording, const Request& request,
                      io::Progress& progress);
// gcal.cpp
void write_gcal(const io::RecordedRun& recording, const Request& request, io::Progress& progress);
// vtk.cpp: a file a frame.
void write_vtk(const io::RecordedRun& recording, const Request& request, io::Progress& progress);

}  // namespace pupflow::exporting
