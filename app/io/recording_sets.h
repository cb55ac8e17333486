// The data sets of a recording that do not grow: dimensions and skin.
#pragma once

#include <string>
#include <vector>

#include "app/io/hdf5_file.h"

namespace pupflow::io {

/// What a data set is: its unit ("1" where `units` is empty) and a sentence.
void describe(const Hdf5Writer& file, hid_t set, std::string_view units,
              std::string_view description);

/// Makes `set` the dimension that is called `name`.
void make_dimension(const Hdf5Writer& file, hid_t set, const std::string& name);

/// Names dimension number `index` of `set`.
void attach_dimension(const Hdf5Writer& file, hid_t set, hid_t dimension, unsigned index);

/// A dimension GROUP/NAME with the coordinates 0 ... size - 1.
Handle write_dimension(const Hdf5Writer& file, const std::string& group, const std::string& name,
                       hsize_t size, std::string_view description);

/// The group skin (pupflow/skin.h) of pups with `face_points` points along a face edge.
void write_skin(const Hdf5Writer& file, int face_points);

}  // namespace pupflow::io
