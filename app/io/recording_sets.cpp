#include "app/io/recording_sets.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include "pupflow/geometry.h"
#include "pupflow/skin.h"

namespace pupflow::io {
namespace {

/// A set of whole numbers, or of directions, in the group skin.
template <class Number>
void write_set(const Hdf5Writer& file, const std::string& name, NumberType type,
               const std::vector<const Handle*>& dimensions, const std::vector<Number>& values,
               std::string_view description) {
  std::vector<hsize_t> shape;
  for (const Handle* dimension : dimensions) {
    const Handle space(file.checked(H5Dget_space(*dimension)), H5Sclose);
    shape.push_back(static_cast<hsize_t>(H5Sget_simple_extent_npoints(space)));
  }
  const Handle set = file.whole("skin/" + name, shape, type, values.data());
  for (unsigned i = 0; i < dimensions.size(); ++i) attach_dimension(file, set, *dimensions[i], i);
  describe(file, set, "", description);
}

}  // namespace

void describe(const Hdf5Writer& file, hid_t set, std::string_view units,
              std::string_view description) {
  file.text(set, "units", units.empty() ? "1" : std::string(units));
  file.text(set, "description", std::string(description));
}

void make_dimension(const Hdf5Writer& file, hid_t set, const std::string& name) {
  file.checked(H5DSset_scale(set, name.c_str()));
}

void attach_dimension(const Hdf5Writer& file, hid_t set, hid_t dimension, unsigned index) {
  file.checked(H5DSattach_scale(set, dimension, index));
}

Handle write_dimension(const Hdf5Writer& file, const std::string& group, const std::string& name,
                       hsize_t size, std::string_view description) {
  std::vector<std::int16_t> numbers(size);
  std::iota(numbers.begin(), numbers.end(), std::int16_t{0});
  Handle set = file.whole(group + "/" + name, {size}, NumberType::i2, numbers.data());
  make_dimension(file, set, name);
  describe(file, set, "", description);
  return set;
}

void write_skin(const Hdf5Writer& file, int face_points) {
  const std::vector<Eigen::Vector3d> directions = cube_sphere(face_points, 1);
  const std::vector<SkinCell> cells = skin_cells(face_points);
  const std::vector<std::vector<int>> lists = skin_neighbours(face_points);
  const SkinSheet sheet = skin_sheet(face_points);
  std::size_t most = 0;
  for (const std::vector<int>& list : lists) most = std::max(most, list.size());

  std::vector<double> direction;
  std::vector<std::int16_t> face, row, column, neighbours;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    direction.insert(direction.end(), directions[i].begin(), directions[i].end());
    face.push_back(static_cast<std::int16_t>(cells[i].face));
    row.push_back(static_cast<std::int16_t>(cells[i].row));
    column.push_back(static_cast<std::int16_t>(cells[i].column));
    neighbours.insert(neighbours.end(), lists[i].begin(), lists[i].end());
    neighbours.resize((i + 1) * most, -1);
  }
  const std::vector<std::int16_t> pixels(sheet.afferent.begin(), sheet.afferent.end());

  const auto size = static_cast<hsize_t>(sheet.size);
  const Handle afferent =
      write_dimension(file, "skin", "afferent", cells.size(), "Point of a pup.");
  const Handle axis = write_dimension(file, "skin", "axis", 3, "x, y, z of the body.");
  const Handle neighbour =
      write_dimension(file, "skin", "neighbour", most, "Place in a list of neighbours.");
  const Handle down =
      write_dimension(file, "skin", "sheet_row", size, "Row of the sheet, from the top.");
  const Handle across =
      write_dimension(file, "skin", "sheet_column", size, "Column of the sheet, from the left.");
  write_set(file, "direction", NumberType::f8, {&afferent, &axis}, direction,
            "Outward direction of the afferent on the pup at rest, in body axes.");
  write_set(file, "face", NumberType::i2, {&afferent}, face,
            "Face of the cube: 0, 1, 2 on the x, y and z axis, 3, 4, 5 opposite.");
  write_set(file, "row", NumberType::i2, {&afferent}, row, "Row within the face.");
  write_set(file, "col", NumberType::i2, {&afferent}, column, "Column within the face.");
  write_set(file, "neighbours", NumberType::i2, {&afferent, &neighbour}, neighbours,
            "Afferents beside it on the skin, ascending; -1 behind the last.");
  write_set(file, "sheet", NumberType::i2, {&down, &across}, pixels,
            "Equal-area image of the skin: the afferent at each pixel.");
}

}  // namespace pupflow::io
