#include "app/io/hdf5_file.h"

#include <hdf5_hl.h>

#include <algorithm>
#include <optional>

#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"
#include "pupflow/parameters.h"

namespace pupflow::io {
namespace {

hid_t open_new(const std::string& path) {
  quiet_hdf5();
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

hid_t open_old(const std::string& path) {
  quiet_hdf5();
  read_beginning(path, 1);  // says what is wrong with a file that cannot be read at all
  return H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
}

/// The text type for one value: variable length, UTF-8.
hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// The value of a text attribute; nothing where it cannot be read.
std::optional<std::string> read_text(hid_t attribute, hid_t type) {
  char* value = nullptr;
  if (H5Aread(attribute, type, &value) < 0) return std::nullopt;
  std::string text = value == nullptr ? "" : value;
  H5free_memory(value);
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

/// Adds one attribute to `data`, a TextEntries; what is neither text nor one number is passed over.
herr_t add_attribute(hid_t file, const char* name, const H5A_info_t*, void* data) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  const Handle space(H5Aget_space(attribute), H5Sclose);
  if (H5Sget_simple_extent_npoints(space) != 1) return 0;
  const H5T_class_t kind = H5Tget_class(type);
  std::optional<std::string> value;
  if (kind == H5T_STRING && H5Tis_variable_str(type) > 0) {
    value = read_text(attribute, type);
  } else if (kind == H5T_INTEGER || kind == H5T_FLOAT) {
    value = read_number_text(attribute, kind == H5T_INTEGER);
  } else {
    return 0;
  }
  if (!value) return -1;
  static_cast<TextEntries*>(data)->emplace_back(name, *value);
  return 0;
}

}  // namespace

void quiet_hdf5() {
  static const herr_t before_all_else = H5dont_atexit();
  static_cast<void>(before_all_else);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hid_t hdf5_type(NumberType type) {
  switch (type) {
    case NumberType::f8:
      return H5T_NATIVE_DOUBLE;
    case NumberType::f4:
      return H5T_NATIVE_FLOAT;
    case NumberType::i8:
      return H5T_NATIVE_INT64;
    case NumberType::i4:
      return H5T_NATIVE_INT32;
    case NumberType::i2:
      return H5T_NATIVE_INT16;
    case NumberType::u1:
      return H5T_NATIVE_UINT8;
  }
  return -1;
}

Hdf5Writer::Hdf5Writer(const std::string& path, bool force)
    : path_(path), target_(path, force), file_(open_new(target_.written_aside())) {
  checked(file_);
}

Hdf5Writer::~Hdf5Writer() {
  if (file_ >= 0) H5Fclose(file_);
}

hid_t Hdf5Writer::checked(hid_t result) const {
  if (result >= 0) return result;
  throw Failure(ExitCode::bad_file, path_ + ": cannot write (is the disk full?)");
}

void Hdf5Writer::text(hid_t object, const std::string& name, const std::string& value) const {
  if (H5Aexists(object, name.c_str()) > 0) checked(H5Adelete(object, name.c_str()));
  const Handle type(text_type(), H5Tclose);
  const Handle space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
  const Handle attribute(
      checked(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT)), H5Aclose);
  const char* data = value.c_str();
  checked(H5Awrite(attribute, type, &data));
}

void Hdf5Writer::add_number(hid_t object, const std::string& name, hid_t type,
                            const void* value) const {
  const Handle space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
  const Handle attribute(
      checked(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT)), H5Aclose);
  checked(H5Awrite(attribute, type, value));
}

void Hdf5Writer::number(hid_t object, const std::string& name, double value) const {
  add_number(object, name, H5T_NATIVE_DOUBLE, &value);
}

void Hdf5Writer::number(hid_t object, const std::string& name, std::int64_t value) const {
  add_number(object, name, H5T_NATIVE_INT64, &value);
}

void Hdf5Writer::about(const TextEntries& entries) const {
  for (const auto& [name, value] : entries) {
    const Parameter* const parameter = find_parameter(name);
    const auto real = read_number<double>(value);
    const auto whole = read_number<std::int64_t>(value);
    if (parameter && parameter->kind == Parameter::Kind::integer && whole) {
      number(file_, name, *whole);
    } else if (parameter && parameter->kind == Parameter::Kind::real && real) {
      number(file_, name, *real);
    } else {
      text(name, value);
    }
  }
}

Handle Hdf5Writer::whole(const std::string& name, const std::vector<hsize_t>& shape,
                         NumberType type, const void* values) const {
  const Handle link(checked(H5Pcreate(H5P_LINK_CREATE)), H5Pclose);
  checked(H5Pset_create_intermediate_group(link, 1));
  const Handle space(
      checked(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr)), H5Sclose);
  const hid_t set = checked(
      H5Dcreate2(file_, name.c_str(), hdf5_type(type), space, link, H5P_DEFAULT, H5P_DEFAULT));
  Handle owner(set, H5Dclose);
  checked(H5Dwrite(set, hdf5_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return owner;
}

void Hdf5Writer::commit() {
  const hid_t file = file_;
  file_ = -1;
  checked(H5Fclose(file));
  target_.commit();
}

Hdf5Reader::Hdf5Reader(const std::string& path) : path_(path), file_(open_old(path), H5Fclose) {
  if (file_ < 0)
    throw Failure(ExitCode::bad_file, path + ": cannot read: is no HDF5 file, or damaged");
}

TextEntries Hdf5Reader::text() const {
  TextEntries entries;
  hsize_t first = 0;
  if (H5Aiterate2(file_, H5_INDEX_NAME, H5_ITER_INC, &first, add_attribute, &entries) < 0) {
    throw Failure(ExitCode::bad_file, path_ + ": cannot read its attributes");
  }
  return entries;
}

bool Hdf5Reader::has(const std::string& name) const {
  return H5Lexists(file_, name.c_str(), H5P_DEFAULT) > 0;
}

template <class T>
std::vector<T> Hdf5Reader::read(const std::string& name, hid_t type) const {
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(set < 0 ? hid_t{-1} : H5Dget_space(set), H5Sclose);
  const hssize_t count = space < 0 ? -1 : H5Sget_simple_extent_npoints(space);
  if (count < 0) {
    refuse(path_ + ": is no checkpoint: there is no " + quoted(name) + " in it");
  }
  std::vector<T> values(static_cast<std::size_t>(count));
  if (count > 0 && H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    throw Failure(ExitCode::bad_file, path_ + ": cannot read " + quoted(name) + " in it");
  }
  return values;
}

namespace {

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

/// Adds what `name` is to `data`, a vector of SetInfo, if it is a data set and no dimension.
herr_t add_set(hid_t file, const char* name, const H5O_info_t* info, void* data) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
  if (set < 0) return -1;
  if (H5DSis_scale(set) > 0) return 0;
  const std::vector<hsize_t> shape = shape_of(set);
  static_cast<std::vector<SetInfo>*>(data)->push_back({name,
                                                       {shape.begin(), shape.end()},
                                                       type_of_set(set),
                                                       text_attribute(set, "units"),
                                                       text_attribute(set, "description")});
  return 0;
}

}  // namespace

std::vector<SetInfo> Hdf5Reader::sets() const {
  std::vector<SetInfo> sets;
  if (H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, add_set, &sets, H5O_INFO_BASIC) < 0) {
    throw Failure(ExitCode::bad_file, path_ + ": cannot read its data sets");
  }
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
  throw Failure(ExitCode::bad_file, path_ + ": cannot read " + quoted(name) + " in it");
}

bool Hdf5Reader::is_filled(const std::string& name) const {
  const Handle set(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle properties(H5Dget_create_plist(set), H5Pclose);
  const std::vector<hsize_t> shape = shape_of(set);
  std::vector<hsize_t> chunk(shape.size());
  hsize_t there = 0, needed = 1;
  const int rank = static_cast<int>(shape.size());
  const Handle all(H5Dget_space(set), H5Sclose);
  if (H5Pget_chunk(properties, rank, chunk.data()) != rank ||
      H5Dget_num_chunks(set, all, &there) < 0) {
    return false;
  }
  for (std::size_t i = 0; i < shape.size(); ++i) needed *= (shape[i] + chunk[i] - 1) / chunk[i];
  return there == needed;
}

std::vector<double> Hdf5Reader::numbers(const std::string& name) const {
  return read<double>(name, H5T_NATIVE_DOUBLE);
}

std::vector<int> Hdf5Reader::integers(const std::string& name) const {
  return read<int>(name, H5T_NATIVE_INT);
}

}  // namespace pupflow::io
