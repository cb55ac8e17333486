#include "app/window/session/worker.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <stdexcept>

namespace pupflow::window {
namespace {

constexpr double kLong = 60;  // seconds

TEST(Worker, IsDoneBeforeItBeganAnything) {
  Worker worker({});
  EXPECT_TRUE(worker.done_within(0));
}

TEST(Worker, WorksOnAThreadOfItsOwnAndSaysWhenItIsDone) {
  std::promise<void> may_end, notified;
  std::thread::id worked_on;
  Worker worker([&] { notified.set_value(); });
  worker.start([&] {
    worked_on = std::this_thread::get_id();
    may_end.get_future().wait();
  });
  EXPECT_TRUE(worker.busy());
  EXPECT_FALSE(worker.done_within(0.001)) << "nobody waits longer than they wanted to";
  may_end.set_value();
  EXPECT_TRUE(worker.done_within(kLong));
  EXPECT_FALSE(worker.busy());
  EXPECT_NE(worked_on, std::this_thread::get_id());
  EXPECT_EQ(notified.get_future().wait_for(std::chrono::seconds(60)), std::future_status::ready);
}

TEST(Worker, DoesOnePieceAfterTheOther) {
  Worker worker({});
  int sum = 0;
  for (int i = 1; i <= 100; ++i) {
    worker.start([&sum, i] { sum += i; });
    ASSERT_TRUE(worker.done_within(kLong));
  }
  EXPECT_EQ(sum, 5050);
}

TEST(Worker, ThrowsWhatTheWorkThrewOnce) {
  Worker worker({});
  worker.start([] { throw std::runtime_error("no memory"); });
  EXPECT_THROW(worker.done_within(kLong), std::runtime_error);
  EXPECT_TRUE(worker.done_within(0));
}

TEST(Worker, EndsAfterItsWork) {
  std::atomic<bool> done = false;
  {
    Worker([&] {}).start([&] { done = true; });
  }
  EXPECT_TRUE(done);
}

}  // namespace
}  // namespace pupflow::window
