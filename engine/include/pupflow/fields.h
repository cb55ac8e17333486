/// @file
/// Every output of the model, once: observables of the litter, fields of a pup, fields of an
/// afferent. Files, tables, plots, colors, docs and tests read these tables, as they read the
/// parameters from `parameters()`.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "pupflow/plan.h"
#include "pupflow/view.h"

#pragma GCC visibility push(default)
namespace pupflow {

/// How the values of a field are to be read, and so drawn.
enum class FieldKind {
  continuous,   ///< from low to high
  signed_,      ///< deviates to both sides of `centre`
  categorical,  ///< whole numbers that only tell apart
  angle         ///< radians; -pi and pi are the same
};

/// "continuous", "signed", "categorical" or "angle".
std::string_view kind_name(FieldKind kind);

/// Stands for an end of a range that is taken from the data.
inline constexpr double kFromData = std::numeric_limits<double>::quiet_NaN();

/// What all rows of the three tables have in common.
struct Field {
  std::string_view name;                   ///< as typed, and of its column in every file
  std::string_view symbol = {};            ///< as written in the docs; may be empty
  std::string_view label;                  ///< a few words for axes and legends
  std::string_view unit = {};              ///< empty when dimensionless
  std::string_view equation = {};          ///< one line; empty where the doc says it all
  std::string_view doc;                    ///< one line, full sentence
  FieldKind kind = FieldKind::continuous;  ///< how its values are to be read
  double low = kFromData;                  ///< low end of the range that it is drawn with
  double high = kFromData;                 ///< high end of that range
  double centre = 0;                       ///< of FieldKind::signed_
  std::span<const std::string_view> categories = {};  ///< names of 0, 1, ...; empty where any goes
  int digits = 3;                                     ///< after the point, where people read it
  PartSet parts = {};       ///< what the step must record for it (Simulation::set_observed)
  bool velocities = false;  ///< whether it reads LitterView::velocities
};

/// A quantity of a pup, or of an afferent (a point of a pup).
struct LitterField : Field {
  /// Fills one value per pup, or per afferent (pup by pup). All are NaN where the view lacks what
  /// the field reads (`is_known`). Throws std::invalid_argument when `values` has another size.
  void fill(const LitterView& litter, std::span<double> values) const;

  /// The same in memory of its own.
  std::vector<double> values(const LitterView& litter) const;

  bool of_afferents = false;   ///< one value per afferent, not per pup
  bool in_files = false;       ///< a column of the pups CSV
  bool in_recordings = false;  ///< a data set of recordings

  /// What `fill` calls once the sizes are right and the view has what it reads.
  void (*formula)(const LitterView&, std::span<double> values) = nullptr;
};

/// Whether the last step recorded, and the view holds, what `field` reads.
bool is_known(const Field& field, const LitterView& litter);

/// All fields of a pup. They live as long as the program.
std::span<const LitterField> pup_fields();

/// All fields of an afferent. They live as long as the program.
std::span<const LitterField> afferent_fields();

/// The field of a pup or an afferent called `name`, or nullptr.
const LitterField* find_field(std::string_view name);

/// What the fields need that are columns of the pups CSV.
PartSet parts_in_files();

/// The observables after one step (Wilson 2017, Results; docs/model.md); NaN where not asked for.
struct Observables {
  double mean_tb = 0;          ///< normalised; mean T_b over pups
  double huddling = 0;         ///< 1 - A, mean over pups
  double groups = 0;           ///< groups of pups that touch; a pup alone is one
  double largest = 0;          ///< pups in the largest group
  double flow = 0;             ///< 1/s; pup flow; also NaN before flow_lag steps have been seen
  double membership_flow = 0;  ///< 1/s; pups whose set of group-mates changed, per pup and second
};

/// The observables, in the order of the files' columns.
enum class Observable { mean_tb, huddling, groups, largest, flow, membership_flow };
/// How many there are.
constexpr std::size_t kObservableCount = 6;

struct Observation;  // what an observer knows after a step (engine/observation.h)

/// A quantity of the litter.
struct ObservableField : Field {
  Observable observable = Observable::mean_tb;      ///< which one it is
  double Observables::*value = nullptr;             ///< its place among the values
  double (*formula)(const Observation&) = nullptr;  ///< for Observer alone
};

/// All observables, in the order of the enum and of the files' columns.
std::span<const ObservableField, kObservableCount> observables();

/// Group of each pup: labels 0, 1, ... in the order of their lowest pup.
std::vector<int> group_labels(int pups, std::span<const TouchingPair> touching);

/// Pups in each of the groups of `labels` (group_labels).
std::vector<int> group_sizes(std::span<const int> labels);

}  // namespace pupflow
#pragma GCC visibility pop
