#include "app/io/named_field.h"

#include <vector>

#include "app/io/failure.h"
#include "app/io/nearest.h"
#include "app/io/text.h"

namespace pupflow::io {

const LitterField& named_field(std::string_view name, const std::string& where) {
  if (const LitterField* field = find_field(name)) return *field;
  std::vector<std::string_view> names;
  for (const auto table : {pup_fields(), afferent_fields()}) {
    for (const LitterField& field : table) names.push_back(field.name);
  }
  const std::string meant = did_you_mean(name, names);
  refuse(where + ": unknown field " + io::quoted(name) +
         (meant.empty() ? "; must be one of " + joined(names, ", ") : meant));
}

}  // namespace pupflow::io
