#include "app/io/note.h"

#include <cstdio>

#include "app/io/text.h"

namespace pupflow::io {

void note(const std::string& text) {
  std::fprintf(stderr, "pupflow: note: %s\n", printable(text).c_str());
}

}  // namespace pupflow::io
