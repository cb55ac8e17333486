// Wilson's GCAL program: HDF5 with P, patterns one after the other, numbers from 0 to 1, each
// pattern row by row, and dims = [width, width, number of patterns].
#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/export/export.h"
#include "app/export/field_stream.h"
#include "app/io/failure.h"
#include "app/io/hdf5_file.h"
#include "app/io/text.h"
#include "pupflow/fields.h"

namespace pupflow::exporting {
namespace {

/// What becomes 0 and 1: as asked for, else the range that the field is drawn with.
Range scale_of(const Request& request, const io::SetInfo& field) {
  if (request.scale) return *request.scale;
  const std::string name = field.name.substr(field.name.find('/') + 1);
  const LitterField* const row = find_field(name);
  if (row && row->low < row->high) return {row->low, row->high};
  io::refuse(name + " has no range of its own; say with --scale MIN,MAX what becomes 0 and 1");
}

/// The data set P. Patterns are written one by one, so that any number of them takes no memory.
class Patterns {
 public:
  Patterns(const io::Hdf5Writer& file, hsize_t numbers)
      : file_(file),
        space_(file.checked(H5Screate_simple(1, &numbers, nullptr)), H5Sclose),
        set_(file.checked(H5Dcreate2(file.id(), "P", H5T_NATIVE_FLOAT, space_, H5P_DEFAULT,
                                     H5P_DEFAULT, H5P_DEFAULT)),
             H5Dclose) {}

  void add(const std::vector<float>& values) {
    const hsize_t count = values.size();
    file_.checked(H5Sselect_hyperslab(space_, H5S_SELECT_SET, &place_, nullptr, &count, nullptr));
    const io::Handle box(file_.checked(H5Screate_simple(1, &count, nullptr)), H5Sclose);
    file_.checked(H5Dwrite(set_, H5T_NATIVE_FLOAT, box, space_, H5P_DEFAULT, values.data()));
    place_ += count;
  }

 private:
  const io::Hdf5Writer& file_;
  io::Handle space_, set_;
  hsize_t place_ = 0;
};

}  // namespace

void write_gcal(const io::RecordedRun& recording, const Request& request, io::Progress& progress) {
  const FieldStream stream(recording, request, {"temperature"}, true);
  const Range scale = scale_of(request, stream.field());
  const std::size_t width = stream.shape().back();
  const std::size_t patterns = recording.frames() * stream.size() / (width * width);
  if (patterns > INT32_MAX) io::refuse(recording.path() + ": holds too many patterns for dims");
  io::Hdf5Writer file(request.out, request.force, io::Hdf5Kind::plain);
  file.about(recording.about());
  file.text("kind", "patterns");
  file.text("name", stream.field().name);
  const std::int32_t dims[] = {static_cast<std::int32_t>(width), static_cast<std::int32_t>(width),
                               static_cast<std::int32_t>(patterns)};
  file.whole("dims", {3}, io::NumberType::i4, dims);
  {
    Patterns all(file, patterns * width * width);
    std::vector<double> values(stream.size());
    std::vector<float> pattern(stream.size());
    stream.for_each_frame(
        io::NumberType::f8, progress, [&](std::size_t frame, std::span<const std::byte> numbers) {
          std::memcpy(values.data(), numbers.data(), numbers.size());
          for (std::size_t i = 0; i < values.size(); ++i) {
            if (std::isnan(values[i])) {
              io::refuse(recording.path() + ": " + stream.field().name +
                         " is not known after step " + std::to_string(recording.steps()[frame]));
            }
            const double share = (values[i] - scale.low) / (scale.high - scale.low);
            pattern[i] = static_cast<float>(std::clamp(share, 0.0, 1.0));
          }
          all.add(pattern);
        });
  }
  file.commit();
}

}  // namespace pupflow::exporting
