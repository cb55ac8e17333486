#include "pupflow/fields.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace pupflow {

std::string_view kind_name(FieldKind kind) {
  switch (kind) {
    case FieldKind::continuous:
      return "continuous";
    case FieldKind::signed_:
      return "signed";
    case FieldKind::categorical:
      return "categorical";
    case FieldKind::angle:
      return "angle";
  }
  return "unknown";
}

bool is_known(const Field& field, const LitterView& litter) {
  return litter.recorded.includes(field.parts) &&
         !(field.velocities && litter.velocities.empty() && litter.pups > 0);
}

void LitterField::fill(const LitterView& litter, std::span<double> values) const {
  const std::size_t wanted =
      static_cast<std::size_t>(litter.pups) * (of_afferents ? litter.points : 1);
  if (values.size() != wanted) {
    throw std::invalid_argument("the span for " + std::string(name) + " holds " +
                                std::to_string(values.size()) + " numbers, not " +
                                std::to_string(wanted));
  }
  if (is_known(*this, litter)) {
    formula(litter, values);
  } else {
    std::fill(values.begin(), values.end(), std::numeric_limits<double>::quiet_NaN());
  }
}

std::vector<double> LitterField::values(const LitterView& litter) const {
  std::vector<double> values(static_cast<std::size_t>(litter.pups) *
                             (of_afferents ? litter.points : 1));
  fill(litter, values);
  return values;
}

const LitterField* find_field(std::string_view name) {
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      if (field.name == name) return &field;
    }
  }
  return nullptr;
}

PartSet parts_in_files() {
  PartSet parts;
  for (const std::span<const LitterField> table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) {
      if (field.in_files) parts = parts | field.parts;
    }
  }
  return parts;
}

}  // namespace pupflow
