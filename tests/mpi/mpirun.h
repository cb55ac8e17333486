// Small sweeps over several ranks, started with mpirun.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/app/program.h"
#include "tests/support/scratch.h"

namespace pupflow::mpi::test {

using pupflow::test::contents;
using pupflow::test::Outcome;
using pupflow::test::Running;
using Words = std::vector<std::string>;

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

class Ranks : public testing::Test {
 protected:
  /// A sweep of `seeds` * 5 runs into the folder `out`; 600 steps take some milliseconds.
  static Words sweep(int seeds, const std::string& out, int steps = 600) {
    return {"sweep",
            "--vary",
            "ta=0:1:5",
            "--seeds",
            std::to_string(seeds),
            "--steps",
            std::to_string(steps),
            "--set",
            "pups=3",
            "--set",
            "discard=100",
            "--set",
            "face_points=3",
            "--out",
            out};
  }

  Outcome alone(const Words& words) const {
    return pupflow::test::run_program(PUPFLOW_PROGRAM, words, folder());
  }

  /// The arguments of `env` that start `ranks` ranks. A rank is lost after a second.
  static Words mpirun(int ranks, const Words& words, const Words& options = {}) {
    return Words{"PUPFLOW_LOST_AFTER=1", PUPFLOW_MPIRUN, "--oversubscribe", "--allow-run-as-root"} +
           options + Words{"-n", std::to_string(ranks), PUPFLOW_PROGRAM} + words;
  }
  Outcome run(const Words& words) const {
    return pupflow::test::run_program("/usr/bin/env", words, folder());
  }

  /// Every file of a folder and of those in it, by its path there, with its bytes.
  std::map<std::string, std::string> files_of(const std::string& name) const {
    const std::string root = scratch_.path(name);
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file()) continue;
      files[std::filesystem::relative(entry.path(), root).string()] =
          contents(entry.path().string());
    }
    return files;
  }
  /// Expects the same files, byte for byte, in two folders. Does not print their bytes.
  void expect_same(const std::string& a, const std::string& b) const {
    const auto in_a = files_of(a), in_b = files_of(b);
    ASSERT_EQ(in_a.size(), in_b.size());
    ASSERT_TRUE(in_a.contains("summary.csv"));
    for (const auto& [name, bytes] : in_a) {
      ASSERT_TRUE(in_b.contains(name)) << name;
      EXPECT_TRUE(in_b.at(name) == bytes) << name << " differs";
    }
  }

  bool exists(const std::string& name) const {
    return std::filesystem::exists(scratch_.path(name));
  }
  std::string folder() const { return scratch_.folder().string(); }

  const pupflow::test::Scratch scratch_;
};

}  // namespace pupflow::mpi::test
