// Files that version 0.1.0 wrote (tests/data/v0.1.0) mean what that version did.
#include <gmock/gmock.h>

#include "app/io/checkpoint.h"
#include "app/io/hdf5_reader.h"
#include "app/io/params_of_file.h"
#include "app/io/scene_file.h"
#include "app/io/settings.h"
#include "pupflow/simulation.h"

namespace pupflow::io {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string old(const std::string& name) {
  return std::string(PUPFLOW_OLD_FILES) + "/" + name;
}

/// What the run was that wrote the files, with the one contact rule of that version.
Params old_params() {
  Params p;
  p.pups = 3;
  p.face_points = 2;
  p.arena_radius = 0.5;
  p.ambient_temperature = 0.2;
  p.contact = ContactRule::sum;
  p.seed = 7;
  p.steps = 120;
  return p;
}

/// The note on standard error when `path` lacks what came after 0.1.0.
std::string note_of(const std::string& path) {
  return "pupflow: note: " + path +
         " was written by an older version; taking contact = sum, flow_lag = 1\n";
}

TEST(OldFiles, GiveTheParametersOfTheirRunWithANote) {
  for (const char* name : {"metrics.csv", "pups.csv", "recording.h5", "checkpoint.h5"}) {
    ::testing::internal::CaptureStderr();
    const Params params = params_of_file(old(name));
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), note_of(old(name)));
    EXPECT_EQ(params, old_params()) << name;
  }
}

TEST(OldFiles, APictureGivesTheParametersOfItsPanels) {
  ::testing::internal::CaptureStderr();
  const Params params = params_of_file(old("figure1.png"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), note_of(old("figure1.png")));
  Params expected;
  expected.contact = ContactRule::sum;
  EXPECT_EQ(params, expected);
}

TEST(OldFiles, ASceneLeavesWhatItDoesNotNameAtItsDefault) {
  Settings settings;
  settings.scene = old("scene.toml");
  ::testing::internal::CaptureStderr();
  const auto setup = set_up(settings);
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), IsEmpty());
  EXPECT_EQ(setup.params.arena_radius, 0.5);
  EXPECT_EQ(setup.params.contact, ContactRule::nearest);
}

TEST(OldFiles, ACheckpointGoesOnAsItDidThen) {
  ::testing::internal::CaptureStderr();
  Simulation simulation(read_checkpoint(old("checkpoint.h5")));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), note_of(old("checkpoint.h5")));
  ASSERT_EQ(simulation.steps_done(), 120);
  ASSERT_TRUE(simulation.run(480).ok());
  EXPECT_EQ(simulation.hash(), 0x9f2069e39f013d9cu);
}

TEST(OldFiles, ARecordingHoldsItsFrames) {
  const Hdf5Reader file(old("recording.h5"));
  EXPECT_THAT(file.numbers("step", {2}), ElementsAre(60, 120));
  EXPECT_EQ(file.numbers("body_temperature", {2, 3}).size(), 2U * 3);
}

}  // namespace
}  // namespace pupflow::io
