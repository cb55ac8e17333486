#include "app/io/hdf5_reader.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "app/io/failure.h"
#include "app/io/hdf5_check.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "app/io/trial.h"
#include "app/io/user_block.h"
#include "pupflow/parameters.h"

namespace pupflow::io {
namespace {

constexpr std::size_t kLongestText = std::size_t{1} << 20, kMostAttributes = 1000;

/// Data sets of so many bytes are read when it is tried whether HDF5 can.
constexpr std::uint64_t kMostTried = std::uint64_t{1} << 20;

/// The value of a text attribute; nothing where it cannot be read.
std::optional<std::string> read_text(hid_t attribute, hid_t type) {
  char* value = nullptr;
  if (H5Aread(attribute, type, &value) < 0) return std::nullopt;
  std::string text = value == nullptr ? "" : value;
  H5free_memory(value);
  if (text.size() > kLongestText) return std::nullopt;
  return text;
}

/// The same for a number, as text that reads back to it.
std::optional<std::string> read_number_text(hid_t attribute, bool whole) {
  std::int64_t integer = 0;
  double real = 0;
  if (whole) {
    if (H5Aread(attribute, H5T_NATIVE_INT64, &integer) < 0) return std::nullopt;
    return std::to_string(integer);
  }
  if (H5Aread(attribute, H5T_NATIVE_DOUBLE, &real) < 0) return std::nullopt;
  return number_text(real);
}

/// Adds one attribute to `data`, a TextEntries. What is neither text nor one number is passed over,
/// but for parameters, which are never anything else.
herr_t add_attribute(hid_t file, const char* name, const H5A_info_t*, void* data) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  const herr_t passed_over = find_parameter(name) ? -1 : 0;
  if (H5Sget_simple_extent_npoints(space) != 1) return passed_over;
  const H5T_class_t kind = H5Tget_class(type);
  std::optional<std::string> value;
  if (kind == H5T_STRING && H5Tis_variable_str(type) > 0) {
    value = read_text(attribute, type);
  } else if (kind == H5T_INTEGER || kind == H5T_FLOAT) {
    value = read_number_text(attribute, kind == H5T_INTEGER);
  } else {
    return passed_over;
  }
  auto& entries = *static_cast<TextEntries*>(data);
  if (!value || entries.size() >= kMostAttributes) return -1;
  entries.emplace_back(name, *value);
  return 0;
}

std::string text_attribute(hid_t object, const char* name) {
  if (H5Aexists(object, name) <= 0) return {};
  TextEntries entries;
  add_attribute(object, name, nullptr, &entries);
  return entries.empty() ? std::string() : entries.front().second;
}

std::string type_of_set(hid_t set) {
  const Handle type(H5Dget_type(set), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind != H5T_INTEGER && kind != H5T_FLOAT) return {};
  const char letter = kind == H5T_FLOAT ? 'f' : H5Tget_sign(type) == H5T_SGN_NONE ? 'u' : 'i';
  return letter + std::to_string(H5Tget_size(type));
}

std::vector<hsize_t> shape_of(hid_t set) {
  const Handle space(H5Dget_space(set), H5Sclose);
  std::vector<hsize_t> shape(std::max(H5Sget_simple_extent_ndims(space), 0));
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

/// Whether it is a dimension scale. H5DSis_scale() of libhdf5 1.10 frees memory twice where the
/// attribute is damaged.
bool is_scale(hid_t set) {
  constexpr std::size_t kLongestClass = 64;
  if (H5Aexists(set, "CLASS") <= 0) return false;
  const Handle attribute(H5Aopen(set, "CLASS", H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0 ||
      H5Tget_size(type) > kLongestClass || H5Sget_simple_extent_npoints(space) != 1) {
    return false;
  }
  char text[kLongestClass + 1] = {};
  return H5Aread(attribute, type, text) >= 0 && std::string_view(text) == "DIMENSION_SCALE";
}

/// Adds what `name` is to `data`, a vector of SetInfo, if it is a data set and no dimension.
herr_t add_set(hid_t file, const char* name, const H5O_info_t* info, void* data) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  if (set < 0) return -1;
  if (is_scale(set)) return 0;
  const std::vector<hsize_t> shape = shape_of(set);
  static_cast<std::vector<SetInfo>*>(data)->push_back({name,
                                                       {shape.begin(), shape.end()},
                                                       type_of_set(set),
                                                       text_attribute(set, "units"),
                                                       text_attribute(set, "description")});
  return 0;
}

/// Whether a data set can grow.
bool grows(hid_t set) {
  const Handle space(H5Dget_space(set), H5Sclose);
  hsize_t limits[H5S_MAX_RANK] = {};
  return H5Sget_simple_extent_dims(space, nullptr, limits) > 0 && limits[0] == H5S_UNLIMITED;
}

/// The frames of a data set in chunks whose chunks are there: chunks of a frame are side by side.
hsize_t frames_with_chunks(hid_t set) {
  const std::vector<hsize_t> shape = shape_of(set);
  std::vector<hsize_t> chunk(shape.size());
  const Handle properties(H5Dget_create_plist(set), H5Pclose), all(H5Dget_space(set), H5Sclose);
  const int rank = static_cast<int>(shape.size());
  hsize_t there = 0, of_frame = 1;
  if (rank == 0 || H5Pget_layout(properties) != H5D_CHUNKED ||
      H5Pget_chunk(properties, rank, chunk.data()) != rank ||
      H5Dget_num_chunks(set, all, &there) < 0) {
    return 0;
  }
  for (std::size_t i = 1; i < shape.size(); ++i) of_frame *= (shape[i] + chunk[i] - 1) / chunk[i];
  return std::min(shape[0], of_frame == 0 ? 0 : there / of_frame * chunk[0]);
}

/// Opens the file by name.
hid_t open_file(const std::string& path, bool unfinished) {
  if (!unfinished) return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access, false, true);  // the run may go on
  // Each try at what is damaged, or is being written, takes twice as long as the one before, from 1 ns.
  constexpr unsigned kTries = 20;
  H5Pset_metadata_read_attempts(access, kTries);
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access);
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path), file_(-1, H5Fclose) {
  quiet_hdf5();
  const auto block = read_user_block(path, read_beginning(path, kUserBlock));
  if (block && block->kind == "checkpoint" && block->checksum) {
    image_ = read_file(path, kLargestChecked);
    check_against(*block, path, image_);
  } else if (block) {
    check_against(*block, path);
    unfinished_ = !block->size;
  }
  // Damaged files may make HDF5 go round in circles; large ones take their time.
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  const unsigned seconds = 2 + static_cast<unsigned>(std::min<std::uintmax_t>(size >> 27, 3600));
  if (!ends_well(seconds, [this] { look_around(); })) fail("is damaged: HDF5 cannot read it");
  open();
}

void Hdf5Reader::open() {
  constexpr unsigned kOurs = H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE;
  file_ = Handle(image_.empty() ? open_file(path_, unfinished_)
                                : H5LTopen_file_image(image_.data(), image_.size(), kOurs),
                 H5Fclose);
  if (file_ < 0) fail("cannot read: is no HDF5 file, or damaged");
  if (const std::string foreign = foreign_part(file_); !foreign.empty()) {
    fail("is damaged, or not of this program: " + foreign);
  }
}

void Hdf5Reader::look_around() {
  // HDF5 may crash as it closes a damaged file, too. Where it wrote behind a buffer of its own, free()
  // finds that as the buffer is given back.
  const std::unique_ptr<Handle, void (*)(Handle*)> closed_at_the_end(&file_, [](Handle* file) {
    *file = Handle(-1, H5Fclose);
    H5garbage_collect();
  });
  open();
  static_cast<void>(text());
  for (const SetInfo& set : sets()) {
    static_cast<void>(frames_there(set.name));
    std::uint64_t bytes = sizeof(double);
    for (const std::uint64_t size : set.shape) {
      bytes = size > kMostTried / bytes ? kMostTried + 1 : bytes * std::max<std::uint64_t>(size, 1);
    }
    if (bytes <= kMostTried) static_cast<void>(numbers(set.name, set.shape));
  }
}

void Hdf5Reader::fail(const std::string& what) const {
  // A kill in the middle of the first flush leaves a file that cannot be opened, or read no further.
  const char* const early =
      unfinished_
          ? "; it is unfinished: its run may have ended before its first frames were written"
          : "";
  throw Failure(ExitCode::bad_file, path_ + ": " + what + early);
}

TextEntries Hdf5Reader::text() const {
  TextEntries entries;
  hsize_t first = 0;
  if (H5Aiterate2(file_, H5_INDEX_NAME, H5_ITER_INC, &first, add_attribute, &entries) < 0) {
    fail("cannot read its attributes");
  }
  return entries;
}

bool Hdf5Reader::has(const std::string& name) const {
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::uint64_t> Hdf5Reader::shape(const std::string& name) const {
  const Handle set(has(name) ? H5Dopen2(file_, name.c_str(), H5P_DEFAULT) : hid_t{-1}, H5Dclose);
  if (set < 0) refuse(path_ + ": is no checkpoint: there is no " + io::quoted(name) + " in it");
  const std::vector<hsize_t> sizes = shape_of(set);
  return {sizes.begin(), sizes.end()};
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& name, const std::vector<std::uint64_t>& shape,
                                hid_t type) const {
  if (this->shape(name) != shape) {
    fail("is damaged: " + io::quoted(name) + " has another size than its parameters say");
  }
  const std::uint64_t count =
      std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  std::vector<T> values(count);
  if (count > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    fail("cannot read " + io::quoted(name) + " in it");
  }
  return values;
}

std::vector<double> Hdf5Reader::numbers(const std::string& name,
                                        const std::vector<std::uint64_t>& shape) const {
  return read<double>(name, shape, H5T_NATIVE_DOUBLE);
}

std::vector<int> Hdf5Reader::integers(const std::string& name,
                                      const std::vector<std::uint64_t>& shape) const {
  return read<int>(name, shape, H5T_NATIVE_INT);
}

std::vector<SetInfo> Hdf5Reader::sets() const {
  std::vector<SetInfo> sets;
  if (H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, add_set, &sets, H5O_INFO_BASIC) < 0) {
    fail("cannot read its data sets");
  }
  if (!unfinished_) return sets;
  // Each grows by itself: the frames of the shortest are whole.
  std::uint64_t shortest = std::numeric_limits<std::uint64_t>::max();
  std::vector<SetInfo*> growing;
  for (SetInfo& set : sets) {
    if (!grows(Handle(H5Dopen2(file_, set.name.c_str(), H5P_DEFAULT), H5Dclose))) continue;
    growing.push_back(&set);
    shortest = std::min(shortest, frames_there(set.name));
  }
  for (SetInfo* set : growing) set->shape[0] = shortest;
  return sets;
}

void Hdf5Reader::part(const std::string& name, const std::vector<std::uint64_t>& first,
                      const std::vector<std::uint64_t>& count, NumberType type,
                      void* values) const {
  const std::vector<hsize_t> begin(first.begin(), first.end()), size(count.begin(), count.end());
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle all(set < 0 ? hid_t{-1} : H5Dget_space(set), H5Sclose);
  const bool fits = all >= 0 && H5Sget_simple_extent_ndims(all) == static_cast<int>(first.size());
  const Handle box(H5Screate_simple(static_cast<int>(size.size()), size.data(), nullptr), H5Sclose);
  if (fits &&
      H5Sselect_hyperslab(all, H5S_SELECT_SET, begin.data(), nullptr, size.data(), nullptr) >= 0 &&
      H5Dread(set, hdf5_type(type), box, all, H5P_DEFAULT, values) >= 0) {
    return;
  }
  fail("cannot read " + io::quoted(name) + " in it");
}

std::uint64_t Hdf5Reader::frames_there(const std::string& name) const {
  return frames_with_chunks(Handle(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose));
}

}  // namespace pupflow::io
