#include "app/io/hdf5_file.h"

#include "app/io/failure.h"
#include "app/io/read_file.h"
#include "app/io/text.h"

namespace pupflow::io {
namespace {

/// HDF5 prints its own account of every error unless told not to; errors are reported here.
void be_quiet() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hid_t open_new(const std::string& path) {
  be_quiet();
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
}

hid_t open_old(const std::string& path) {
  be_quiet();
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

/// Adds one attribute to `data`, a TextEntries; other kinds than text are passed over.
herr_t add_attribute(hid_t file, const char* name, const H5A_info_t*, void* data) {
  const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
  const Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) <= 0) return 0;
  char* value = nullptr;
  if (H5Aread(attribute, type, &value) < 0) return -1;
  if (value != nullptr) static_cast<TextEntries*>(data)->emplace_back(name, value);
  H5free_memory(value);
  return 0;
}

}  // namespace

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
  const Handle type(text_type(), H5Tclose);
  const Handle space(checked(H5Screate(H5S_SCALAR)), H5Sclose);
  const Handle attribute(
      checked(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT)), H5Aclose);
  const char* data = value.c_str();
  checked(H5Awrite(attribute, type, &data));
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

std::vector<double> Hdf5Reader::numbers(const std::string& name) const {
  return read<double>(name, H5T_NATIVE_DOUBLE);
}

std::vector<int> Hdf5Reader::integers(const std::string& name) const {
  return read<int>(name, H5T_NATIVE_INT);
}

}  // namespace pupflow::io
