// ParaView and OVITO: VTK's PolyData (.vtp), a file a frame, as text.
#include <cmath>
#include <cstring>

#include "app/export/export.h"
#include "app/export/field_stream.h"
#include "app/io/atomic_file.h"
#include "app/io/failure.h"
#include "app/io/frame_path.h"
#include "app/io/interrupt.h"
#include "app/io/text.h"

namespace pupflow::exporting {
namespace {

/// A value for each point of the file.
struct Column {
  std::string name;
  std::vector<double> values;
};

/// One frame: the recorded points, or the pups' centres where no points are recorded.
struct Frame {
  std::vector<double> xyz;
  std::vector<Column> columns;
};

class FrameReader {
 public:
  FrameReader(const io::RecordedRun& recording, std::optional<int> pup)
      : recording_(recording), pup_(pup), positions_(recording.find("position")) {
    for (std::size_t axis = 0; axis < 3 && !positions_; ++axis) {
      centre_[axis] = recording.find(std::string(1, "xyz"[axis]));
      if (!centre_[axis]) {
        io::refuse(recording.path() +
                   ": holds neither points nor centres; record them with --record-fields "
                   "pup,point");
      }
    }
    pups_ = pup ? 1 : static_cast<std::size_t>(recording.params().pups);
    points_ = positions_ ? static_cast<std::size_t>(points_per_pup(recording.params())) : 1;
  }

  std::size_t points() const { return pups_ * points_; }

  Frame read(std::size_t frame) const {
    Frame all;
    all.xyz.resize(3 * points());
    if (positions_) {
      recording_.read(*positions_, frame, 1, pup_, io::NumberType::f8, all.xyz.data());
    }
    for (std::size_t axis = 0; axis < 3 && !positions_; ++axis) {
      const std::vector<double> values = numbers(*centre_[axis], frame, 1);
      for (std::size_t i = 0; i < values.size(); ++i) all.xyz[3 * i + axis] = values[i];
    }
    all.columns.push_back({"pup", {}});
    for (std::size_t i = 0; i < points(); ++i) {
      all.columns.back().values.push_back(static_cast<double>(i / points_) + pup_.value_or(0));
    }
    all.columns.push_back({"radius", std::vector<double>(points(), radius())});
    for (const io::SetInfo& field : recording_.fields()) add_column(field, frame, all);
    return all;
  }

 private:
  double radius() const {
    const Params& params = recording_.params();
    return positions_ ? params.point_radius : params.pup_radius + params.point_radius;
  }

  std::vector<double> numbers(const io::SetInfo& field, std::size_t frame, std::size_t each) const {
    std::vector<double> values(pups_ * each);
    recording_.read(field, frame, 1, pup_, io::NumberType::f8, values.data());
    return values;
  }

  /// Fields of pups for each of their points, those of afferents where there are points.
  void add_column(const io::SetInfo& field, std::size_t frame, Frame& all) const {
    const bool of_afferents = field.name.starts_with("afferent/");
    if (field.shape.size() > 3 || (of_afferents && !positions_)) return;
    Column column{field.name.substr(field.name.find('/') + 1), {}};
    const std::vector<double> values = numbers(field, frame, of_afferents ? points_ : 1);
    for (std::size_t i = 0; i < points(); ++i) {
      column.values.push_back(values[of_afferents ? i : i / points_]);
    }
    all.columns.push_back(std::move(column));
  }

  const io::RecordedRun& recording_;
  std::optional<int> pup_;
  const io::SetInfo* positions_;
  const io::SetInfo* centre_[3] = {};
  std::size_t pups_, points_;
};

void write_array(io::AtomicFile& file, const std::string& name, int components,
                 const std::vector<double>& values) {
  std::string text = "<DataArray type=\"Float64\" Name=\"" + name + "\" NumberOfComponents=\"" +
                     std::to_string(components) + "\" format=\"ascii\">\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += io::number_text(values[i]);
    text += (i + 1) % static_cast<std::size_t>(components) == 0 ? '\n' : ' ';
  }
  file.write(text + "</DataArray>\n");
}

/// Points show in ParaView where each is a vertex.
void write_vertices(io::AtomicFile& file, std::size_t points) {
  std::string connectivity, offsets;
  for (std::size_t i = 0; i < points; ++i) {
    connectivity += std::to_string(i) + "\n";
    offsets += std::to_string(i + 1) + "\n";
  }
  file.write("<Verts>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" +
             connectivity +
             "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" +
             offsets + "</DataArray>\n</Verts>\n");
}

/// What made the recording. A comment must not hold two dashes.
std::string comment(const io::RecordedRun& recording) {
  std::string text;
  for (const auto& [name, value] : recording.about()) text += name + " = " + value + "\n";
  for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) text[at] = ' ';
  return "<!--\n" + text + "-->\n";
}

void write_frame(const std::string& path, const io::RecordedRun& recording, bool force, double time,
                 const Frame& frame) {
  io::AtomicFile file(path, force);
  const std::size_t points = frame.xyz.size() / 3;
  file.write("<?xml version=\"1.0\"?>\n" + comment(recording) +
             "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
             "<PolyData>\n<FieldData>\n"
             "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
             "format=\"ascii\">" +
             io::number_text(time) + "</DataArray>\n</FieldData>\n<Piece NumberOfPoints=\"" +
             std::to_string(points) + "\" NumberOfVerts=\"" + std::to_string(points) +
             "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<Points>\n");
  write_array(file, "Points", 3, frame.xyz);
  file.write("</Points>\n");
  write_vertices(file, points);
  file.write("<PointData Scalars=\"tb\">\n");
  for (const Column& column : frame.columns) write_array(file, column.name, 1, column.values);
  file.write("</PointData>\n</Piece>\n</PolyData>\n</VTKFile>\n");
  file.commit();
}

}  // namespace

void write_vtk(const io::RecordedRun& recording, const Request& request, io::Progress& progress) {
  if (!request.field.empty() || request.sheet) {
    io::refuse("--format vtk writes all fields that are recorded; leave out --field and --sheet");
  }
  if (!io::has_number(request.out) && recording.frames() > 1) {
    io::refuse("--out " + request.out + ": each of the " + std::to_string(recording.frames()) +
               " frames needs a file; name them like NAME-%05d.vtp");
  }
  const auto path = [&](std::size_t frame) {
    return io::frame_path(request.out, recording.steps()[frame]);
  };
  const FrameReader reader(recording, request.pup);
  for (std::size_t i = 0; i < recording.frames(); ++i) io::refuse_existing(path(i), request.force);
  for (std::size_t i = 0; i < recording.frames(); ++i) {
    if (io::interrupted()) {
      throw io::Failure(io::ExitCode::interrupted, "interrupted after " + std::to_string(i) +
                                                       " of " + std::to_string(recording.frames()) +
                                                       " files");
    }
    write_frame(path(i), recording, request.force, recording.times()[i], reader.read(i));
    progress.update(static_cast<std::int64_t>(i + 1));
  }
}

}  // namespace pupflow::exporting
