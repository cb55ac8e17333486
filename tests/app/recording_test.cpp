// What recordings hold, chunk by chunk, and what is refused when they are read.
#include "app/io/recording.h"

#include <gmock/gmock.h>

#include <chrono>
#include <set>
#include <thread>

#include "app/io/hdf5_reader.h"
#include "app/io/params_of_file.h"
#include "app/io/provenance.h"
#include "app/io/recorded_run.h"
#include "app/io/user_block.h"
#include "failing.h"
#include "hdf5_edit.h"
#include "pupflow/simulation.h"
#include "tests/support/scratch.h"

namespace pupflow::io {
namespace {

using ::testing::Contains;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::Pair;

Params small() {
  Params p;
  p.pups = 3;
  p.face_points = 2;
  p.arena_radius = 0.5;
  p.ambient_temperature = 0.1 + 0.2;  // a number that short text would not keep
  p.seed = 9007199254740991;
  return p;
}

/// Records `frames` frames of a litter, step by step, and returns what its fields were.
class Recorded {
 public:
  Recorded(const std::string& path, const Params& p, const std::string& names, int frames) {
    const RecordedFields recorded = parse_recorded_fields(names);
    Simulation s(p);
    s.set_observed(recorded.parts());
    Recording recording(path, false, p, provenance(p), recorded);
    for (int frame = 0; frame < frames; ++frame) {
      if (frame > 0) s.step();
      recording.add(s);
      for (const LitterField* field : recorded.fields) {
        const std::vector<double> now = field->values(s);
        std::vector<double>& all = values[std::string(field->name)];
        all.insert(all.end(), now.begin(), now.end());
      }
      std::vector<double> xyz(std::size_t{3} * s.pups() * s.points());
      s.view().positions.copy_to(xyz);
      positions.insert(positions.end(), xyz.begin(), xyz.end());
    }
    recording.commit("");
  }
  std::map<std::string, std::vector<double>> values;
  std::vector<double> positions;
};

TEST(Recording, HoldsWhatTheLitterWas) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    for (const int frames : {1, 64, 150}) {  // part of a chunk, a whole one, several
      const test::Scratch scratch;
      Params p = small();
      p.precision = precision;
      const Recorded was(scratch.path("r.h5"), p, "pup,afferent,point,strain,speed", frames);
      const RecordedRun run(scratch.path("r.h5"));
      EXPECT_EQ(run.params(), p);
      ASSERT_EQ(run.frames(), static_cast<std::size_t>(frames));
      EXPECT_EQ(run.steps().back(), frames - 1);
      EXPECT_EQ(run.times().back(), (frames - 1) * p.dt);
      EXPECT_EQ(run.fields().size(), 15 + 1 + 4 + 1u);
      for (const auto& [name, values] : was.values) {
        const SetInfo* const set = run.find(name);
        ASSERT_NE(set, nullptr) << name;
        std::vector<double> read(values.size());
        run.read(*set, 0, run.frames(), {}, NumberType::f8, read.data());
        for (std::size_t i = 0; i < read.size(); ++i) {
          const double stored = set->type == "f4" ? static_cast<float>(values[i]) : values[i];
          ASSERT_EQ(read[i], stored) << name << ' ' << i;
        }
      }
      const SetInfo* const positions = run.find("position");
      ASSERT_NE(positions, nullptr);
      EXPECT_EQ(positions->type, precision == Precision::float_ ? "f4" : "f8");
      std::vector<double> read(was.positions.size());
      run.read(*positions, 0, run.frames(), {}, NumberType::f8, read.data());
      EXPECT_EQ(read, was.positions);
    }
  }
}

TEST(Recording, OfALargeLitterHasFewerFramesOfMorePupsInAChunk) {
  const test::Scratch scratch;
  Params p = small();
  p.pups = 1001;  // the last chunk is filled in part
  p.start = Start::carpet;
  p.arena_radius = 20;
  const Recorded was(scratch.path("r.h5"), p, "tb,point", 60);
  const RecordedRun run(scratch.path("r.h5"));
  std::vector<double> read(was.positions.size());
  run.read(*run.find("position"), 0, run.frames(), {}, NumberType::f8, read.data());
  EXPECT_EQ(read, was.positions);
  const Handle file(H5Fopen(scratch.path("r.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const auto chunk_of = [&](const char* name) {
    const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Handle properties(H5Dget_create_plist(set), H5Pclose);
    std::vector<hsize_t> chunk(4);
    chunk.resize(static_cast<std::size_t>(H5Pget_chunk(properties, 4, chunk.data())));
    return chunk;
  };
  EXPECT_THAT(chunk_of("pup/tb"), ElementsAre(64, 1));
  EXPECT_THAT(chunk_of("point/position"), ElementsAre(58, 2, 24, 3));
}

TEST(Recording, OnePupsStreamIsReadAlone) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "afferent", 70);
  const RecordedRun run(scratch.path("r.h5"));
  std::vector<double> read(5 * 24);
  run.read(*run.find("touched"), 62, 5, 2, NumberType::f8, read.data());
  for (std::size_t frame = 0; frame < 5; ++frame) {
    for (std::size_t i = 0; i < 24; ++i) {
      EXPECT_EQ(read[frame * 24 + i], was.values.at("touched")[((62 + frame) * 3 + 2) * 24 + i]);
    }
  }
}

TEST(Recording, HoldsNothingThatWasNotAskedFor) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "pup", 2);
  for (const SetInfo& set : Hdf5Reader(scratch.path("r.h5")).sets()) {
    EXPECT_THAT(set.name, testing::Not(testing::AnyOf(testing::StartsWith("afferent/"),
                                                      testing::StartsWith("point/"))));
  }
}

TEST(Recording, KeepsParametersAsNumbersAndChoicesAsText) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "tb", 1);
  EXPECT_EQ(params_of_file(scratch.path("r.h5")), small());
  EXPECT_THAT(Hdf5Reader(scratch.path("r.h5")).text(),
              testing::AllOf(Contains(Pair("ta", "0.30000000000000004")),
                             Contains(Pair("seed", "9007199254740991")),
                             Contains(Pair("contact", "nearest")), Contains(Pair("layout", "2"))));
}

TEST(Recording, OfNoFrameAndOfNoPupIsWholeToo) {
  const test::Scratch scratch;
  Recording(scratch.path("none.h5"), false, small(), provenance(small()),
            parse_recorded_fields("pup,point"))
      .commit("interrupted");
  const RecordedRun none(scratch.path("none.h5"));
  EXPECT_EQ(none.frames(), 0u);
  EXPECT_THAT(none.about(), Contains(Pair("ended early", "interrupted")));
  Params p = small();
  p.pups = 0;
  const Recorded was(scratch.path("nobody.h5"), p, "pup,afferent,point", 3);
  const RecordedRun nobody(scratch.path("nobody.h5"));
  EXPECT_EQ(nobody.frames(), 3u);
  EXPECT_THAT(nobody.fields(), IsEmpty());
}

TEST(Recording, WhatACheckpointDoesNotKeepIsMarkedAsNotKnown) {
  const test::Scratch scratch;
  Simulation first(small());
  first.run(5);
  Simulation s(first.snapshot());
  const RecordedFields fields = parse_recorded_fields("t_left,side,touched");
  s.set_observed(fields.parts());
  {
    Recording recording(scratch.path("r.h5"), false, small(), provenance(small()), fields);
    recording.add(s);
    recording.commit("");
  }
  double warmth = 0, side = 0, touched = 0;
  const Hdf5Reader file(scratch.path("r.h5"));
  file.part("pup/t_left", {0, 0}, {1, 1}, NumberType::f8, &warmth);
  file.part("afferent/side", {0, 0, 0}, {1, 1, 1}, NumberType::f8, &side);
  file.part("afferent/touched", {0, 0, 0}, {1, 1, 1}, NumberType::f8, &touched);
  EXPECT_TRUE(std::isnan(warmth));
  EXPECT_EQ(side, 255);
  EXPECT_EQ(touched, -1);  // contacts are kept
}

TEST(Recording, AppearsWholeOrNotAtAll) {
  const test::Scratch scratch;
  Simulation s(small());
  {
    Recording abandoned(scratch.path("r.h5"), false, small(), provenance(small()),
                        parse_recorded_fields("pup"));
    for (int i = 0; i < 200; ++i) abandoned.add(s);  // some of it is on its way to the disk
    EXPECT_FALSE(std::filesystem::exists(scratch.path("r.h5")));
  }
  EXPECT_EQ(scratch.entries(), 0);
}

TEST(Recording, ChunksThatWereFlushedInPartHoldWhatTheLitterWas) {
  const test::Scratch scratch;
  std::vector<double> warmth;
  {
    Simulation s(small());
    Recording recording(scratch.path("r.h5"), false, small(), provenance(small()),
                        parse_recorded_fields("tb"));
    for (int frame = 0; frame < 70; ++frame) {
      if (frame % 5 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
      recording.add(s);
      for (const double tb : find_field("tb")->values(s)) warmth.push_back(tb);
      s.step();
    }
    recording.commit("");
  }
  const RecordedRun run(scratch.path("r.h5"));
  ASSERT_EQ(run.frames(), 70u);
  std::vector<double> read(warmth.size());
  run.read(*run.find("tb"), 0, 70, {}, NumberType::f8, read.data());
  EXPECT_EQ(read, warmth);
}

TEST(Recording, EveryByteThatChangesIsFound) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "tb", 3);
  std::string bytes = test::contents(scratch.path("r.h5"));
  for (std::size_t i = 0; i < bytes.size(); i += i < kUserBlock + 100 ? 1 : 61) {
    const char good = bytes[i];
    bytes[i] = static_cast<char>(good ^ (1 << i % 8));
    const std::string damaged = scratch.file("damaged.h5", bytes);
    test::failure_of(ExitCode::bad_file, [&] { const RecordedRun run(damaged); });
    bytes[i] = good;
  }
  EXPECT_NO_THROW(RecordedRun(scratch.file("damaged.h5", bytes)));
}

/// What the recording was before its end was written.
std::string unfinished(const std::string& path) {
  std::string bytes = test::contents(path);
  const std::string block = block_text({"recording", {}, {}});
  return bytes.replace(0, block.size(), block);
}

TEST(Recording, NumbersOfAnUnfinishedOneHaveChecksumsOfTheirOwn) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "tb", 3);
  std::string bytes = unfinished(scratch.path("r.h5"));
  const auto read = [&] {
    const RecordedRun run(scratch.file("u.h5", bytes));
    std::vector<double> numbers(9);
    run.read(*run.find("tb"), 0, 3, {}, NumberType::f8, numbers.data());
    return numbers;
  };
  ASSERT_EQ(read(), was.values.at("tb"));
  const Handle file(H5Fopen(scratch.path("r.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const Handle set(H5Dopen2(file, "pup/tb", H5P_DEFAULT), H5Dclose);
  const hsize_t first[] = {0, 0};
  hsize_t size = 0;
  ASSERT_GE(H5Dget_chunk_storage_size(set, first, &size), 0);
  std::string chunk(size, '\0');
  std::uint32_t mask = 0;
  ASSERT_GE(H5Dread_chunk(set, H5P_DEFAULT, first, &mask, chunk.data()), 0);
  const std::size_t place = bytes.find(chunk);
  ASSERT_NE(place, std::string::npos);
  for (std::size_t i = 0; i < size; i += 3) {
    char& byte = bytes[place + i];
    byte = static_cast<char>(byte ^ 1);
    EXPECT_THAT(test::failure_of(ExitCode::bad_file, read), HasSubstr("cannot read 'pup/tb'")) << i;
    byte = static_cast<char>(byte ^ 1);
  }
}

TEST(Recording, ADamagedUnfinishedOneIsRefusedAtOnce) {
  // HDF5 reads what has a wrong checksum again, as long as it is told: the test would time out.
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "tb", 3);
  std::string bytes = unfinished(scratch.path("r.h5"));
  int refused = 0;
  for (std::size_t i = kUserBlock; i < bytes.size(); i += 499) {
    const char good = bytes[i];
    bytes[i] = static_cast<char>(~good);
    try {
      const RecordedRun run(scratch.file("u.h5", bytes));
    } catch (const Failure&) {
      ++refused;
    }
    bytes[i] = good;
  }
  EXPECT_GT(refused, 5);
}

TEST(Recording, OneCutInItsFirstFlushSaysThatItsRunEndedThen) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "tb", 3);
  std::string bytes = unfinished(scratch.path("r.h5"));
  std::set<std::string> said;
  for (std::size_t kept = kUserBlock + 48; kept < kUserBlock + 1600; kept += 100) {
    std::string cut = bytes;
    std::fill(cut.begin() + static_cast<std::ptrdiff_t>(kept), cut.end(), '\0');
    try {
      const RecordedRun run(scratch.file("u.h5", cut));
    } catch (const Failure& failure) {
      said.insert(failure.what());
    }
  }
  EXPECT_THAT(said, Not(IsEmpty()));
  EXPECT_THAT(
      said, Each(HasSubstr("; it is unfinished: its run may have ended before its first frames")));
}

TEST(Recording, CannotGoToAPipe) {
  const auto to_device = [] {
    const Recording r("/dev/null", true, small(), provenance(small()), {});
  };
  EXPECT_THAT(test::failure_of(ExitCode::bad_file, to_device), HasSubstr("name a file"));
}

TEST(RecordedFields, AreNamedByGroupOrField) {
  const RecordedFields some = parse_recorded_fields("tb,afferent,touched");
  std::vector<std::string_view> names;
  for (const LitterField* field : some.fields) names.push_back(field->name);
  EXPECT_THAT(names, ElementsAre("tb", "temperature", "touched", "side"));
  EXPECT_FALSE(some.positions);
  EXPECT_TRUE(some.parts().includes({Part::owners, Part::pairs, Part::sides}));
  EXPECT_FALSE(some.parts().has(Part::pose));
  for (const char* wrong : {"", "pup,", "points", "Pup"}) {
    EXPECT_THAT(test::failure_of(ExitCode::bad_input, [&] { parse_recorded_fields(wrong); }),
                HasSubstr("--record-fields"))
        << wrong;
  }
  EXPECT_THAT(test::failure_of(ExitCode::bad_input, [] { parse_recorded_fields("points"); }),
              HasSubstr("point"));
}

TEST(RecordedRun, RefusesWhatIsNoRecordingOfThisLayout) {
  const test::Scratch scratch;
  const auto refused = [](const std::string& path) {
    return test::failure_of(ExitCode::bad_input, [&] { const RecordedRun run(path); });
  };
  EXPECT_THAT(refused(std::string(PUPFLOW_OLD_FILES) + "/recording.h5"), HasSubstr("layout 1"));
  EXPECT_THAT(refused(std::string(PUPFLOW_OLD_FILES) + "/checkpoint.h5"),
              HasSubstr("is no recording"));
  const Recorded was(scratch.path("r.h5"), small(), "pup", 70);
  const std::string bytes = test::contents(scratch.path("r.h5"));
  const std::string cut = scratch.file("cut.h5", bytes.substr(0, bytes.size() / 2));
  test::failure_of(ExitCode::bad_file, [&] { const RecordedRun run(cut); });
}

TEST(RecordedRun, RefusesSizesThatItsParametersDoNotSay) {
  const test::Scratch scratch;
  const Recorded was(scratch.path("r.h5"), small(), "pup", 3);
  const auto refused = [&] {
    return test::failure_of(ExitCode::bad_file,
                            [&] { const RecordedRun run(scratch.path("r.h5")); });
  };
  test::edit_hdf5(scratch.path("r.h5"), "recording", [](hid_t file) {
    const Handle set(H5Dopen2(file, "pup/tb", H5P_DEFAULT), H5Dclose);
    const hsize_t extent[] = {4, 3};
    ASSERT_GE(H5Dset_extent(set, extent), 0);
  });
  EXPECT_THAT(refused(), HasSubstr("'pup/tb' has another size"));
  test::edit_hdf5(scratch.path("r.h5"), "recording", [](hid_t file) {
    const Handle set(H5Dopen2(file, "step", H5P_DEFAULT), H5Dclose);
    const hsize_t extent[] = {hsize_t{1} << 40};
    ASSERT_GE(H5Dset_extent(set, extent), 0);
  });
  EXPECT_THAT(refused(), HasSubstr("the size of 'step'"));
}

}  // namespace
}  // namespace pupflow::io
