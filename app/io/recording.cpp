#include "app/io/recording.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/io/hdf5_file.h"
#include "app/io/provenance.h"
#include "pupflow/fields.h"

namespace pupflow::io {
namespace {

/// A dataset that grows by one row for each frame.
class Series {
 public:
  /// `shape` is that of one frame; `stored` the type in the file.
  Series(const Hdf5Writer& file, const std::string& name, const std::vector<hsize_t>& shape,
         hid_t stored)
      : file_(file),
        extent_(with_frames(0, shape)),
        set_(make(file, name, shape, stored), H5Dclose) {}

  /// An attribute.
  void text(const std::string& name, const std::string& value) {
    if (set_ >= 0) file_.text(set_, name, value);
  }

  void add(hid_t type, const void* data) {
    if (set_ < 0) return;
    std::vector<hsize_t> start(extent_.size(), 0), count = extent_;
    start[0] = extent_[0]++;
    count[0] = 1;
    file_.checked(H5Dset_extent(set_, extent_.data()));
    const Handle all(file_.checked(H5Dget_space(set_)), H5Sclose);
    file_.checked(
        H5Sselect_hyperslab(all, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    const Handle one(
        file_.checked(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr)),
        H5Sclose);
    file_.checked(H5Dwrite(set_, type, one, all, H5P_DEFAULT, data));
  }

 private:
  static std::vector<hsize_t> with_frames(hsize_t frames, std::vector<hsize_t> shape) {
    shape.insert(shape.begin(), frames);
    return shape;
  }

  /// One chunk a frame; none at all for a litter without pups, which has nothing to store.
  static hid_t make(const Hdf5Writer& file, const std::string& name,
                    const std::vector<hsize_t>& shape, hid_t stored) {
    for (const hsize_t size : shape) {
      if (size == 0) return -1;
    }
    const std::vector<hsize_t> extent = with_frames(0, shape),
                               limit = with_frames(H5S_UNLIMITED, shape);
    // Rows of single numbers come a thousand to a chunk.
    const std::vector<hsize_t> chunk = with_frames(shape.empty() ? 1024 : 1, shape);
    const auto rank = static_cast<int>(extent.size());
    const Handle space(file.checked(H5Screate_simple(rank, extent.data(), limit.data())), H5Sclose);
    const Handle properties(file.checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
    file.checked(H5Pset_chunk(properties, rank, chunk.data()));
    const Handle link(file.checked(H5Pcreate(H5P_LINK_CREATE)), H5Pclose);
    file.checked(H5Pset_create_intermediate_group(link, 1));
    return file.checked(
        H5Dcreate2(file.id(), name.c_str(), stored, space, link, properties, H5P_DEFAULT));
  }

  const Hdf5Writer& file_;
  std::vector<hsize_t> extent_;
  Handle set_;
};

}  // namespace

class Recording::File {
 public:
  File(const std::string& path, bool force, const Params& params)
      : writer(path, force),
        xyz(3 * static_cast<std::size_t>(params.pups) * points_per_pup(params)) {
    for (const auto& [name, value] : provenance(params)) writer.text(name, value);
    writer.text("kind", "recording");
    writer.text("layout", "2");
    sets.emplace(writer, static_cast<hsize_t>(params.pups),
                 static_cast<hsize_t>(points_per_pup(params)));
  }

  struct Sets {
    Sets(const Hdf5Writer& file, hsize_t pups, hsize_t points)
        : step(file, "step", {}, H5T_STD_I64LE),
          time(file, "time", {}, H5T_IEEE_F64LE),
          position(file, "point/position", {pups, points, 3}, H5T_IEEE_F32LE) {
      for (const LitterField& field : pup_fields()) {
        if (!field.in_files) continue;
        const std::string name = "pup/" + std::string(field.name);
        by_pup.emplace_back(&field, std::make_unique<Series>(file, name, std::vector<hsize_t>{pups},
                                                             H5T_IEEE_F64LE));
        by_pup.back().second->text("unit", std::string(field.unit));
        by_pup.back().second->text("description", std::string(field.doc));
      }
    }
    Series step, time, position;
    std::vector<std::pair<const LitterField*, std::unique_ptr<Series>>> by_pup;
  };

  Hdf5Writer writer;
  std::vector<float> xyz;
  std::optional<Sets> sets;  // closed before the file is
};

Recording::Recording(const std::string& path, bool force, const Params& params)
    : file_(std::make_unique<File>(path, force, params)) {}

Recording::~Recording() = default;

void Recording::add(const LitterView& litter) {
  litter.positions.copy_to(std::span<float>(file_->xyz));
  file_->sets->step.add(H5T_NATIVE_INT64, &litter.step);
  file_->sets->time.add(H5T_NATIVE_DOUBLE, &litter.time);
  file_->sets->position.add(H5T_NATIVE_FLOAT, file_->xyz.data());
  for (const auto& [field, series] : file_->sets->by_pup) {
    series->add(H5T_NATIVE_DOUBLE, field->values(litter).data());
  }
}

void Recording::commit(const std::string& ending) {
  if (!ending.empty()) file_->writer.text("ended early", ending);
  file_->sets.reset();
  file_->writer.commit();
}

}  // namespace pupflow::io
