// Checkpoints, whole and damaged.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <csignal>
#include <functional>
#include <random>
#include <thread>

#include "app/io/checkpoint.h"
#include "app/io/checksum.h"
#include "app/io/hdf5_reader.h"
#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "app/io/user_block.h"
#include "failing.h"
#include "hdf5_edit.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using ::testing::HasSubstr;

Params small() {
  Params p;
  p.pups = 3;
  p.face_points = 3;
  p.ambient_temperature = 0.1 + 0.2;  // a number that short text would not keep
  return p;
}

TEST(Checkpoint, GoesOnBitForBit) {
  const test::Scratch scratch;
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    Params p = small();
    p.precision = precision;
    Simulation whole(p);
    whole.run(200);
    const std::string path = scratch.path("c.h5");
    write_checkpoint(path, true, whole);
    Simulation restored(read_checkpoint(path));
    EXPECT_EQ(restored.params(), p);
    EXPECT_EQ(restored.hash(), whole.hash());
    whole.run(200);
    restored.run(200);
    EXPECT_EQ(restored.hash(), whole.hash());
    EXPECT_EQ(restored.time(), whole.time());
  }
}

TEST(Checkpoint, AnEmptyLitterHasOneToo) {
  const test::Scratch scratch;
  Params p = small();
  p.pups = 0;
  Simulation s(p);
  s.run(5);
  write_checkpoint(scratch.path("c.h5"), false, s);
  EXPECT_EQ(read_checkpoint(scratch.path("c.h5")).step, 5);
}

TEST(Checkpoint, OtherFilesAreRefused) {
  const test::Scratch scratch;
  const std::string text = scratch.file("text", "hello");
  EXPECT_THAT(test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(text); }),
              HasSubstr("text"));
  test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(scratch.path("nothing")); });

  const std::string whole = scratch.path("whole.h5");
  write_checkpoint(whole, false, Simulation(small()));
  const std::string bytes = test::contents(whole);
  const std::string cut = scratch.file("cut.h5", bytes.substr(0, bytes.size() / 2));
  test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(cut); });

  const std::string recording = scratch.path("r.h5");
  Recording(recording, false, small(), provenance(small()), {}).commit("");
  EXPECT_THAT(test::failure_of(ExitCode::bad_input, [&] { read_checkpoint(recording); }),
              HasSubstr("is no checkpoint"));
}

/// A small litter of which a checkpoint has few bytes.
std::string smallest(const test::Scratch& scratch) {
  Params p = small();
  p.pups = 2;
  p.face_points = 2;
  write_checkpoint(scratch.path("c.h5"), true, Simulation(p));
  return scratch.path("c.h5");
}

TEST(Checkpoint, EveryByteThatChangesIsFound) {
  const test::Scratch scratch;
  std::string bytes = test::contents(smallest(scratch));
  // All of the first line and HDF5's head, then every eleventh.
  for (std::size_t i = 0; i < bytes.size(); i += i < kUserBlock + 100 ? 1 : 11) {
    const char was = bytes[i];
    bytes[i] = static_cast<char>(was ^ (1 << i % 8));
    const std::string damaged = scratch.file("damaged.h5", bytes);
    const std::string message =
        test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(damaged); });
    ASSERT_THAT(message, HasSubstr("damaged.h5: ")) << i;
    ASSERT_EQ(message.find('\n'), std::string::npos);
    bytes[i] = was;
  }
  EXPECT_NO_THROW(read_checkpoint(scratch.file("damaged.h5", bytes)));
}

TEST(Checkpoint, EveryByteThatIsMissingOrTooManyIsFound) {
  const test::Scratch scratch;
  const std::string bytes = test::contents(smallest(scratch));
  for (std::size_t size = 0; size < bytes.size(); size += 101) {
    const std::string cut = scratch.file("cut.h5", bytes.substr(0, size));
    test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(cut); });
  }
  const std::string longer = scratch.file("longer.h5", bytes + '\0');
  EXPECT_THAT(test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(longer); }),
              HasSubstr("is damaged: has"));
}

TEST(Checkpoint, WhatHdf5CrashesOnIsRefused) {
  // Bytes changed behind the first line, with a checksum that fits: some crash HDF5 (1.10.8: one in
  // thirty).
  const test::Scratch scratch;
  const std::string whole = test::contents(smallest(scratch)).substr(kUserBlock);
  std::mt19937 draw(1);
  int refused = 0;
  for (int i = 0; i < 80; ++i) {
    std::string bytes = whole;
    for (int change = 0; change < 4; ++change) {
      bytes[draw() % bytes.size()] = static_cast<char>(draw());
    }
    const UserBlock block{"checkpoint", kUserBlock + bytes.size(), checksum(bytes)};
    try {
      read_checkpoint(scratch.file("m.h5", block_text(block) + bytes));
    } catch (const Failure&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 8);
  EXPECT_LT(refused, 80);
}

TEST(Checkpoint, OfEqualLittersAreEqual) {
  const test::Scratch scratch;
  const std::string first = test::contents(smallest(scratch));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // what tells whole seconds
  EXPECT_EQ(test::contents(smallest(scratch)), first);
}

TEST(Checkpoint, IsAFileThatHdf5Opens) {
  const test::Scratch scratch;
  const Handle file(H5Fopen(smallest(scratch).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  ASSERT_GE(file, 0);
  EXPECT_GT(H5Lexists(file, "position", H5P_DEFAULT), 0);
}

/// A checkpoint that `change` made another, with a checksum that fits: what somebody might send.
class ForeignCheckpoint : public ::testing::Test {
 protected:
  std::string made(const std::function<void(hid_t)>& change) const {
    const std::string path = smallest(scratch_);
    test::edit_hdf5(path, "checkpoint", change);
    return path;
  }
  std::string refused(const std::function<void(hid_t)>& change) const {
    const std::string path = made(change);
    return test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(path); });
  }
  test::Scratch scratch_;
};

void replace_set(hid_t file, const char* name, const std::vector<hsize_t>& shape, hid_t type,
                 hid_t properties = H5P_DEFAULT) {
  ASSERT_GE(H5Ldelete(file, name, H5P_DEFAULT), 0);
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose);
  const Handle set(H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                   H5Dclose);
  ASSERT_GE(set, 0);
}

TEST_F(ForeignCheckpoint, IsReadWhereNothingChanged) {
  EXPECT_EQ(read_checkpoint(made([](hid_t) {})).step, 0);
}

TEST_F(ForeignCheckpoint, SizesThatTheParametersDoNotSayTakeNoMemory) {
  const hsize_t huge = hsize_t{1} << 37;
  for (const char* name : {"position", "velocity", "body_temperature", "felt_tb", "heading",
                           "exposed", "touched", "clock"}) {
    EXPECT_THAT(refused([&](hid_t file) { replace_set(file, name, {huge}, H5T_NATIVE_DOUBLE); }),
                HasSubstr("'" + std::string(name) + "' has another size"));
  }
  EXPECT_THAT(refused([&](hid_t file) {
                replace_set(file, "touching", {huge, 2}, H5T_NATIVE_INT);
              }),
              HasSubstr("more pairs touch"));
}

TEST_F(ForeignCheckpoint, LinksToOtherPlacesAreRefused) {
  EXPECT_THAT(refused([](hid_t file) {
                H5Lcreate_external("/etc/passwd", "x", file, "more", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("'more' is a link to another place"));
  EXPECT_THAT(refused([](hid_t file) {
                H5Lcreate_soft("/nowhere", file, "more", H5P_DEFAULT, H5P_DEFAULT);
              }),
              HasSubstr("'more' is a link to another place"));
}

TEST_F(ForeignCheckpoint, NumbersInOtherFilesAreRefused) {
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  ASSERT_GE(H5Pset_external(properties, "/etc/passwd", 0, H5F_UNLIMITED), 0);
  EXPECT_THAT(refused([&](hid_t file) {
                replace_set(file, "heading", {2}, H5T_NATIVE_DOUBLE, properties);
              }),
              HasSubstr("'heading' keeps its numbers in another file"));
}

TEST_F(ForeignCheckpoint, OtherFiltersChunksAndTypesAreRefused) {
  const hsize_t two = 2, many = hsize_t{1} << 29;
  const Handle packed(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  ASSERT_GE(H5Pset_chunk(packed, 1, &two), 0);
  ASSERT_GE(H5Pset_scaleoffset(packed, H5Z_SO_INT, 0), 0);
  EXPECT_THAT(
      refused([&](hid_t file) { replace_set(file, "heading", {2}, H5T_NATIVE_INT, packed); }),
      HasSubstr("another filter"));
  const Handle large(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  ASSERT_GE(H5Pset_chunk(large, 1, &many), 0);
  EXPECT_THAT(
      refused([&](hid_t file) { replace_set(file, "heading", {many}, H5T_NATIVE_CHAR, large); }),
      HasSubstr("too large chunks"));
  EXPECT_THAT(refused([&](hid_t file) { replace_set(file, "heading", {2}, H5T_C_S1); }),
              HasSubstr("has no numbers"));
}

TEST_F(ForeignCheckpoint, ParametersAreOneNumberOrText) {
  const auto with_many = [](hid_t file) {
    ASSERT_GE(H5Adelete(file, "ta"), 0);
    const hsize_t many = 1000;
    const Handle space(H5Screate_simple(1, &many, nullptr), H5Sclose);
    const Handle attribute(
        H5Acreate2(file, "ta", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    const std::vector<double> values(many, 0.5);
    ASSERT_GE(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data()), 0);
  };
  EXPECT_THAT(refused(with_many), HasSubstr("cannot read its attributes"));
}

TEST_F(ForeignCheckpoint, TextIsBounded) {
  const auto with_long_text = [](hid_t file) {
    const std::string text(std::size_t{1} << 21, 'x');
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
    H5Tset_size(type, H5T_VARIABLE);
    const Handle attribute(H5Acreate2(file, "long", type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    const char* value = text.c_str();
    ASSERT_GE(H5Awrite(attribute, type, &value), 0);
  };
  EXPECT_THAT(refused(with_long_text), HasSubstr("cannot read its attributes"));
}

TEST(Checkpoint, CannotGoToADevice) {
  EXPECT_THAT(test::failure_of(ExitCode::bad_file,
                               [] { write_checkpoint("/dev/null", true, Simulation(small())); }),
              HasSubstr("name a file"));
}

TEST(Checkpoint, AFullDiskIsReportedAndTheOldOneStays) {
  const test::Scratch scratch;
  const std::string path = scratch.file("c.h5", "old");
  const rlimit few{2000, RLIM_INFINITY};
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &few), 0);
  EXPECT_THROW(write_checkpoint(path, true, Simulation(small())), Failure);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(test::contents(path), "old");
  EXPECT_EQ(scratch.entries(), 1);
}

TEST(Checkpoint, AnExistingFileStays) {
  const test::Scratch scratch;
  const std::string path = scratch.file("c.h5", "mine");
  test::failure_of(ExitCode::bad_file, [&] { write_checkpoint(path, false, Simulation(small())); });
  EXPECT_EQ(test::contents(path), "mine");
  EXPECT_EQ(scratch.entries(), 1);
}

}  // namespace
}  // namespace pupflow::io
