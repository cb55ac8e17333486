// The observables of a whole run, for plots.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "pupflow/fields.h"

namespace pupflow::window {

/// Samples of a run in levels. A sample of level 0 is one step; one of the next level joins the
/// kMerged steps that share a place in it, and so on. Each level keeps its newest samples, so a
/// stretch of any length has some hundreds of them, and memory stays bounded however long the run
/// is.
///
/// A copy shares the samples, so it costs little. It does not change when the original goes on, and
/// another thread may read it.
class History {
 public:
  static constexpr int kMerged = 4;      // samples that one of the next level joins
  static constexpr int kSamples = 2048;  // that a level keeps, at least
  static constexpr int kLevels = 12;
  static constexpr std::size_t kTbBytes = std::size_t{8} << 20;  // for the T_b of every pup

  /// A stretch of steps.
  struct Sample {
    std::int64_t first = 0, last = 0;  // of its steps
    int steps = 0;                     // that were seen
    double time = 0;                   // model seconds after the last of them
    Observables mean;                  // over the steps at which an observable is known
    std::array<float, kObservableCount> low{}, high{};  // of each observable
    double coldest = 0, warmest = 0;                    // T_b of any pup
    double ta = 0, tp = 0;                              // T_a and T_p, means
  };

  /// A sample as it is read.
  struct Entry {
    const Sample* sample;       // valid as long as the history is neither changed nor destroyed
    std::span<const float> tb;  // of each pup after the last step; empty where it is not kept
  };

  /// Adds what was seen after `step`. A step that is not after all others changes nothing: it was
  /// gone through before.
  void add(std::int64_t step, double time, const Observables& seen, const LitterView& litter);

  /// Forgets what was seen after `step`. Of a sample that holds steps before and after, what a finer
  /// level does not know goes, too.
  void truncate(std::int64_t step);

  void clear() { *this = History{}; }

  bool empty() const { return last_ < first_; }
  std::int64_t first() const { return first_; }  // step; meaningless when empty
  std::int64_t last() const { return last_; }

  /// The finest samples that cover these steps, `most` of a level or fewer, oldest first, and the
  /// neighbours just outside. Where a level begins too late, a coarser one stands in.
  std::vector<Entry> between(std::int64_t first, std::int64_t last,
                             std::int64_t most = kSamples) const;

  /// Whether T_b of each pup is kept for litters of that size.
  static bool keeps_tb(int pups) { return tb_pages(pups) >= 2; }

 private:
  static constexpr int kPage = 64;  // samples

  /// Some samples. Written once, in order, and only behind what others know of it.
  struct Page {
    std::shared_ptr<std::array<Sample, kPage>> samples;
    std::shared_ptr<std::vector<float>> tb;  // sample by sample, or nothing
  };

  /// Whether the last page may be written to. A copy may not.
  struct Owner {
    Owner() = default;
    Owner(const Owner&) {}
    Owner& operator=(const Owner&) {
      is_owner = false;
      return *this;
    }
    bool is_owner = false;
  };

  struct Level {
    std::vector<Page> pages;
    std::size_t size = 0;  // samples in all pages
    Owner tail;
    Sample open;  // what will be the next sample; nothing while open.steps == 0

    const Sample& at(std::size_t i) const { return (*pages[i / kPage].samples)[i % kPage]; }
    std::size_t first_after(std::int64_t step) const;
    void make_room(std::size_t pups);
    void push(const Sample& sample, std::span<const float> tb, int pups);
    void cut(std::int64_t step);
  };

  static std::size_t tb_pages(int pups);
  Entry entry(const Level& level, std::size_t i) const;
  void pass_up(std::size_t level, const Sample& sample, std::span<const float> tb);

  std::array<Level, kLevels> levels_;
  std::int64_t first_ = 1, last_ = 0;
  int pups_ = 0;
};

}  // namespace pupflow::window
