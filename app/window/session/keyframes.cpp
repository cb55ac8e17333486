#include "app/window/session/keyframes.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pupflow::window {
namespace {

template <class Value>
std::size_t bytes_of(const std::vector<Value>& values) {
  return values.capacity() * sizeof(Value);
}

std::size_t bytes_of(const Snapshot& snapshot) {
  return sizeof snapshot + bytes_of(snapshot.positions) + bytes_of(snapshot.velocities) +
         bytes_of(snapshot.body_temperature) + bytes_of(snapshot.felt_tb) +
         bytes_of(snapshot.heading) + bytes_of(snapshot.exposed) + bytes_of(snapshot.touched) +
         bytes_of(snapshot.touching) + bytes_of(snapshot.actions);
}

}  // namespace

void Keyframes::add(const Simulation& simulation) {
  auto frame = std::make_shared<Snapshot>(simulation.snapshot());
  frame->params.schedule = {};
  frames_.push_back(std::move(frame));
}

std::shared_ptr<const Snapshot> Keyframes::at_or_before(std::int64_t steps) const {
  const auto after =
      std::upper_bound(frames_.begin(), frames_.end(), steps,
                       [](std::int64_t step, const auto& frame) { return step < frame->step; });
  return after == frames_.begin() ? nullptr : *std::prev(after);
}

void Keyframes::cut(std::int64_t steps) {
  while (!frames_.empty() && frames_.back()->step > steps) frames_.pop_back();
}

void Keyframes::keep_within(std::size_t bytes) {
  while (!frames_.empty() && this->bytes() > bytes) {
    spacing_ *= 2;
    std::erase_if(frames_, [&](const auto& frame) { return frame->step % spacing_ != 0; });
  }
}

std::size_t Keyframes::bytes() const {
  return std::accumulate(frames_.begin(), frames_.end(), std::size_t{0},
                         [](std::size_t sum, const auto& frame) { return sum + bytes_of(*frame); });
}

}  // namespace pupflow::window
