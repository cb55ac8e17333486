// A step allocates nothing once the first steps have made room. Counts every call of operator new
// in this program, which is why it is one of its own.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "pupflow/observer.h"
#include "pupflow/simulation.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return counted(size, alignof(std::max_align_t));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace pupflow {
namespace {

long allocations_of(const Params& params, int threads, int warm_up, int steps) {
  Simulation simulation(params);
  simulation.set_threads(threads);
  EXPECT_TRUE(simulation.run(warm_up).ok());
  const long before = allocations;
  EXPECT_TRUE(simulation.run(steps).ok());
  return allocations - before;
}

TEST(Allocation, TheCounterCounts) {
  const long before = allocations;
  const std::vector<int> numbers(1000);
  EXPECT_EQ(allocations - before, 1);
  const Simulation simulation{Params{}};
  EXPECT_GT(allocations - before, 10);
}

TEST(Allocation, NoneInAStepAfterWarmUp) {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    for (const double ta : {0.2, 0.8}) {
      Params p;
      p.precision = precision;
      p.ambient_temperature = ta;
      EXPECT_EQ(allocations_of(p, 1, 5, 1000), 0) << ta;  // through the fall and the landing
    }
  }
}

TEST(Allocation, NoneWithManyPupsAndThreads) {
  Params p;
  p.pups = 150;
  p.face_points = 4;
  p.arena_radius = 3;
  p.start = Start::carpet;
  EXPECT_EQ(allocations_of(p, 3, 5, 300), 0);
}

TEST(Allocation, NoneForRigidOrExplicitBodies) {
  Params rigid;
  rigid.deformation = 0;
  rigid.heading = Heading::body;
  EXPECT_EQ(allocations_of(rigid, 1, 5, 300), 0);
  Params direct;
  direct.integrator = Integrator::explicit_;
  EXPECT_EQ(allocations_of(direct, 1, 5, 100), 0);
}

}  // namespace
}  // namespace pupflow
