// Checkpoints.
#include <gmock/gmock.h>

#include "app/io/checkpoint.h"
#include "app/io/hdf5_file.h"
#include "app/io/provenance.h"
#include "app/io/recording.h"
#include "failing.h"
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

TEST(Checkpoint, AnExistingFileStays) {
  const test::Scratch scratch;
  const std::string path = scratch.file("c.h5", "mine");
  test::failure_of(ExitCode::bad_file, [&] { write_checkpoint(path, false, Simulation(small())); });
  EXPECT_EQ(test::contents(path), "mine");
  EXPECT_EQ(scratch.entries(), 1);
}

}  // namespace
}  // namespace pupflow::io
