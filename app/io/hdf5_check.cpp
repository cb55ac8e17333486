#include "app/io/hdf5_check.h"

#include <algorithm>
#include <array>

#include "app/io/hdf5_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

constexpr int kMostLinks = 1000, kMostDimensions = 4;
constexpr hsize_t kLargestChunk = hsize_t{1} << 28;  // bytes

struct Look {
  int links = 0;
  std::string problem;
};

bool is_known_filter(hid_t properties, unsigned number) {
  unsigned flags = 0;
  std::size_t values = 0;
  const H5Z_filter_t filter =
      H5Pget_filter2(properties, number, &flags, &values, nullptr, 0, nullptr, nullptr);
  return filter == H5Z_FILTER_SHUFFLE || filter == H5Z_FILTER_DEFLATE ||
         filter == H5Z_FILTER_FLETCHER32;
}

/// Bytes of a chunk; 0 where the data set has none.
hsize_t chunk_bytes(hid_t properties, std::size_t number_bytes) {
  std::array<hsize_t, kMostDimensions> sizes{};
  if (H5Pget_layout(properties) != H5D_CHUNKED) return 0;
  const int rank = H5Pget_chunk(properties, kMostDimensions, sizes.data());
  hsize_t bytes = number_bytes;
  for (int i = 0; i < std::min(rank, kMostDimensions); ++i) {
    if (sizes[i] > kLargestChunk / bytes) return kLargestChunk + 1;
    bytes *= std::max<hsize_t>(sizes[i], 1);
  }
  return bytes;
}

/// What is wrong with a data set.
std::string problem_of_set(hid_t set) {
  const Handle type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  const Handle properties(H5Dget_create_plist(set), H5Pclose);
  if (type < 0 || space < 0 || properties < 0) return "cannot be read";
  const H5T_class_t kind = H5Tget_class(type);
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) || H5Tget_size(type) > 8) return "has no numbers";
  if (H5Sget_simple_extent_ndims(space) > kMostDimensions) return "has too many dimensions";
  if (H5Pget_external_count(properties) != 0 || H5Pget_layout(properties) == H5D_VIRTUAL) {
    return "keeps its numbers in another file";
  }
  const int filters = H5Pget_nfilters(properties);
  for (int i = 0; i < filters; ++i) {
    if (!is_known_filter(properties, static_cast<unsigned>(i)))
      return "is packed by another filter";
  }
  if (chunk_bytes(properties, H5Tget_size(type)) > kLargestChunk) return "has too large chunks";
  return {};
}

std::string problem_of_object(hid_t file, const char* name) {
  const Handle object(H5Oopen(file, name, H5P_DEFAULT), H5Oclose);
  if (object < 0) return "cannot be read";
  switch (H5Iget_type(object)) {
    case H5I_GROUP:
      return {};
    case H5I_DATASET:
      return problem_of_set(object);
    default:
      return "is neither group nor data set";
  }
}

/// Of H5Lvisit, which follows no link out of the file. Stops at the first problem.
herr_t look_at(hid_t file, const char* name, const H5L_info_t* link, void* data) {
  auto& look = *static_cast<Look*>(data);
  std::string problem;
  if (++look.links > kMostLinks) {
    problem = "is one object too many";
  } else {
    problem =
        link->type == H5L_TYPE_HARD ? problem_of_object(file, name) : "is a link to another place";
  }
  if (problem.empty()) return 0;
  look.problem = io::quoted(name) + " " + problem;
  return 1;
}

}  // namespace

std::string foreign_part(hid_t file) {
  Look look;
  if (H5Lvisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, look_at, &look) < 0) {
    return "its groups cannot be read";
  }
  return look.problem;
}

}  // namespace pupflow::io
