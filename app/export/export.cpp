#include "app/export/export.h"

#include <array>

#include "app/io/failure.h"
#include "app/io/text.h"

namespace pupflow::exporting {
namespace {

constexpr std::array kFormats{
    Format{
        "npy",
        "the field as an array, for numpy; with --out 'NAME-%05d.npy' an image a frame, for ImaGen",
        write_npy},
    Format{"timedarray", "values (frame, channel), dt and start in an .npz file, for Brian2",
           write_timedarray},
    Format{"gcal", "patterns P and their dims in an HDF5 file, for Wilson's GCAL program",
           write_gcal},
    Format{"vtk",
           "points with T_b, a .vtp file a frame (--out 'NAME-%05d.vtp'), for ParaView and OVITO",
           write_vtk},
};

}  // namespace

std::span<const Format> formats() {
  return kFormats;
}

void export_recording(const io::RecordedRun& recording, std::string_view format,
                      const Request& request, io::Progress& progress) {
  const int pups = recording.params().pups;
  if (recording.frames() == 0 || pups == 0) {
    io::refuse(recording.path() + ": holds no frame of a pup, so there is nothing to export");
  }
  if (request.pup && *request.pup >= pups) {
    io::refuse("--pup: there is no pup " + std::to_string(*request.pup) + "; " + recording.path() +
               " has 0 to " + std::to_string(pups - 1));
  }
  for (const Format& row : formats()) {
    if (row.name == format) return row.write(recording, request, progress);
  }
  io::refuse("--format: there is no " + io::quoted(format) + "; there are " +
             io::joined(formats(), ", ", [](const Format& row) { return std::string(row.name); }));
}

}  // namespace pupflow::exporting
