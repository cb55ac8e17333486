// numpy and ImaGen: .npy files.
#include "app/export/array_file.h"
#include "app/export/export.h"
#include "app/export/field_stream.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"

namespace pupflow::exporting {
namespace {

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// (frame, pup, ...) in one file, with the type of the recording.
void write_array(const FieldStream& stream, const io::RecordedRun& recording,
                 const Request& request, io::Progress& progress) {
  std::vector<std::size_t> shape = stream.shape();
  shape.insert(shape.begin(), recording.frames());
  io::AtomicFile file(request.out, request.force);
  file.write(npy_header(npy_type(stream.type()), shape));
  stream.for_each_frame(stream.type(), progress, [&](std::size_t, std::span<const std::byte> row) {
    file.write(as_text(row));
  });
  file.commit();
}

/// (row, column, 1) in a file a frame, numbered by step: what ImaGen's FileImage reads.
void write_images(const FieldStream& stream, const io::RecordedRun& recording,
                  const Request& request, io::Progress& progress) {
  if (stream.shape().size() != 2) {
    io::refuse("--out " + request.out + ": an image a frame is of one pup; choose it with --pup");
  }
  std::vector<std::size_t> shape = stream.shape();
  shape.push_back(1);
  const std::string header = npy_header(npy_type(io::NumberType::f8), shape);
  for (const std::int64_t step : recording.steps()) {
    io::refuse_existing(io::frame_path(request.out, step), request.force);
  }
  stream.for_each_frame(
      io::NumberType::f8, progress, [&](std::size_t frame, std::span<const std::byte> row) {
        io::AtomicFile file(io::frame_path(request.out, recording.steps()[frame]), request.force);
        file.write(header);
        file.write(as_text(row));
        file.commit();
      });
}

}  // namespace

void write_npy(const io::RecordedRun& recording, const Request& request, io::Progress& progress) {
  const bool images = io::has_number(request.out);
  const FieldStream stream(recording, request, {"temperature", "tb"}, request.sheet || images);
  images ? write_images(stream, recording, request, progress)
         : write_array(stream, recording, request, progress);
}

}  // namespace pupflow::exporting
