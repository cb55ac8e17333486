#include "app/window/session/history.h"

#include <gtest/gtest.h>

#include <string>

namespace pupflow::window {
namespace {

Observables with_groups(double groups) {
  Observables seen;
  seen.groups = groups;
  return seen;
}

std::size_t row_called(const std::string& name) {
  for (std::size_t k = 0; k < kObservableCount; ++k) {
    if (name == observables()[k].name) return k;
  }
  return kObservableCount;
}

TEST(History, ASampleIsTheMeanOfItsSteps) {
  History history;
  for (int i = 1; i < History::kStepsPerSample; ++i) history.add(i, with_groups(i));
  EXPECT_EQ(history.size(), 0);
  history.add(History::kStepsPerSample, with_groups(History::kStepsPerSample));
  ASSERT_EQ(history.size(), 1);
  EXPECT_FLOAT_EQ(history.value(row_called("groups"), 0), (1 + History::kStepsPerSample) / 2.0f);
  EXPECT_EQ(history.time(0), History::kStepsPerSample);
}

TEST(History, KeepsTheNewestInOrder) {
  History history;
  const int samples = History::kSamples + 7;
  for (int i = 0; i < samples * History::kStepsPerSample; ++i) {
    history.add(i, with_groups(i / History::kStepsPerSample));
  }
  ASSERT_EQ(history.size(), History::kSamples);
  for (int i = 0; i < history.size(); ++i) {
    ASSERT_EQ(history.value(row_called("groups"), i), static_cast<float>(7 + i));
  }
  history.clear();
  EXPECT_EQ(history.size(), 0);
}

}  // namespace
}  // namespace pupflow::window
