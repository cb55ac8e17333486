// CMake says what the version is.
#include "pupflow/version.h"

namespace pupflow {

Version version() {
  return {PUPFLOW_VERSION_MAJOR, PUPFLOW_VERSION_MINOR, PUPFLOW_VERSION_PATCH};
}

std::string_view version_text() {
  return PUPFLOW_VERSION;
}

}  // namespace pupflow
