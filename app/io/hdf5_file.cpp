#include "app/io/hdf5_file.h"

#include <algorithm>
#include <new>

#include "app/io/checksum.h"
#include "app/io/failure.h"
#include "app/io/text.h"
#include "app/io/user_block.h"
#include "pupflow/parameters.h"

namespace pupflow::io {
namespace {

/// A file at `path`, or in memory only for a checkpoint.
hid_t open_new(const std::string& path, Hdf5Kind kind) {
  constexpr std::size_t kGrowth = std::size_t{1} << 20;
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (kind != Hdf5Kind::plain) H5Pset_userblock(creation, kUserBlock);
  if (kind == Hdf5Kind::checkpoint) {
    H5Pset_fapl_core(access, kGrowth, false);
  } else {
    H5Pset_file_locking(access, false, true);  // AtomicFile locks it
  }
  // Metadata with checksums, written in an order that leaves the file readable at any moment.
  if (kind == Hdf5Kind::recording) {
    H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  }
  return H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access);
}

/// Starts HDF5, which takes a while, before there is a file.
const std::string& started(const std::string& path) {
  quiet_hdf5();
  return path;
}

const char* name_of(Hdf5Kind kind) {
  return kind == Hdf5Kind::checkpoint ? "checkpoint" : "recording";
}

/// The text type for one value: variable length, UTF-8.
hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

}  // namespace

void quiet_hdf5() {
  static const herr_t before_all_else = H5dont_atexit();
  static_cast<void>(before_all_else);
  // What fails here is an allocation, and HDF5 is not usable after it.
  if (H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr) < 0) throw std::bad_alloc();
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

Hdf5Writer::Hdf5Writer(const std::string& path, bool force, Hdf5Kind kind)
    : path_(started(path)),
      kind_(kind),
      target_(path, force),
      file_(open_new(target_.written_aside(), kind)) {
  checked(file_);
}

Hdf5Writer::~Hdf5Writer() {
  const bool kept = failed_ && flushed_;
  if (kept) target_.keep();
  // Closing would say that all is written; so HDF5 lets go of it only at the end of the program.
  if (file_ >= 0 && !kept) H5Fclose(file_);
}

hid_t Hdf5Writer::checked(hid_t result) const {
  if (result >= 0) return result;
  failed_ = true;
  std::string message = path_ + ": cannot write (is the disk full?)";
  if (flushed_) message += "; what was recorded is in " + target_.written_aside();
  throw Failure(ExitCode::bad_file, message);
}

void Hdf5Writer::only_grow() {
  checked(H5Fstart_swmr_write(file_));
  target_.write_at_start(block_text({name_of(kind_), {}, {}}));  // only now can it be read
}

void Hdf5Writer::flush() const {
  checked(H5Fflush(file_, H5F_SCOPE_LOCAL));
  flushed_ = true;
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
  const Handle properties(checked(H5Pcreate(H5P_DATASET_CREATE)), H5Pclose);
  const bool empty = std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end();
  if (kind_ == Hdf5Kind::recording && !empty) {  // all of it a chunk, with a checksum
    checked(H5Pset_chunk(properties, static_cast<int>(shape.size()), shape.data()));
    checked(H5Pset_fletcher32(properties));
  }
  const hid_t set = checked(
      H5Dcreate2(file_, name.c_str(), hdf5_type(type), space, link, properties, H5P_DEFAULT));
  Handle owner(set, H5Dclose);
  checked(H5Dwrite(set, hdf5_type(type), H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  return owner;
}

std::string Hdf5Writer::image() const {
  checked(H5Fflush(file_, H5F_SCOPE_LOCAL));
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  checked(size < 0 ? -1 : 0);
  std::string bytes(kUserBlock + static_cast<std::size_t>(size), '\0');  // the block is left out
  checked(H5Fget_file_image(file_, bytes.data() + kUserBlock, bytes.size() - kUserBlock) < 0 ? -1
                                                                                             : 0);
  return bytes;
}

void Hdf5Writer::commit() {
  std::string bytes = kind_ == Hdf5Kind::checkpoint ? image() : std::string();
  const hid_t file = file_;
  file_ = -1;
  checked(H5Fclose(file));
  if (kind_ == Hdf5Kind::checkpoint) {
    const std::uint64_t sum = checksum(std::string_view(bytes).substr(kUserBlock));
    bytes.replace(0, kUserBlock, block_text({name_of(kind_), bytes.size(), sum}));
    target_.write(bytes);
  } else if (kind_ == Hdf5Kind::recording) {
    target_.write_at_start(block_text(block_of(name_of(kind_), target_.written_aside())));
  }
  target_.commit();
}

}  // namespace pupflow::io
