// Preloaded in tests that look for leaks: what was loaded stays, so that LeakSanitizer knows whose memory
// a leak is, and leaks.txt can name the drivers that keep some until the end.
#include <dlfcn.h>

extern "C" __attribute__((visibility("default"))) int dlclose(void* /*module*/) {
  return 0;
}
