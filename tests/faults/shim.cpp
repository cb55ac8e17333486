// A library to preload: makes the n-th call of one kind fail, in the process of one program only.
// PUPFLOW_FAULT: "KIND:N" (only the N-th call) or "KIND:N+" (the N-th and all later ones). N = 0
// fails none. PUPFLOW_FAULT_REPORT: a file that gets "fired" when a call fails, and "count=N", how
// many calls there were, when the process ends. PUPFLOW_FAULT_PLACES: a file that gets the number of
// each allocation whose innermost callers are new, but a graphics driver's. PUPFLOW_FAULT_PROGRAM: the
// program's file name.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <iterator>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

enum Kind {
  none,
  reads,
  writes,
  shorts,
  pwrites,
  syncs,
  renames,
  opens,
  closes,
  mkdirs,
  mallocs,
  threads
};

struct Name {
  const char* text;
  Kind kind;
  int error;
};
constexpr Name kNames[] = {
    {"read", reads, EIO},        {"write", writes, ENOSPC},  {"short", shorts, 0},
    {"pwrite", pwrites, ENOSPC}, {"fsync", syncs, EIO},      {"rename", renames, EACCES},
    {"open", opens, EMFILE},     {"close", closes, EIO},     {"mkdir", mkdirs, ENOSPC},
    {"malloc", mallocs, ENOMEM}, {"thread", threads, EAGAIN}};

Kind chosen = none;
int chosen_error = 0;
long wanted = 0;
bool all_later = false;
std::atomic<long> calls{0};
const char* report_path = nullptr;
const char* places_path = nullptr;

void append(const char* path, const char* text) {
  if (!path) return;
  const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND, 0666);
  if (file < 0) return;
  syscall(SYS_write, file, text, std::strlen(text));
  syscall(SYS_close, file);
}

bool is_program() {
  const char* name = std::getenv("PUPFLOW_FAULT_PROGRAM");
  char path[4096];
  const long length = syscall(SYS_readlink, "/proc/self/exe", path, sizeof path - 1);
  if (!name || length < 0) return false;
  path[length] = '\0';
  const char* slash = std::strrchr(path, '/');
  return slash && std::strcmp(slash + 1, name) == 0;
}

void begin() {
  const char* fault = std::getenv("PUPFLOW_FAULT");
  const char* colon = fault ? std::strchr(fault, ':') : nullptr;
  if (!colon || !is_program()) return;
  report_path = std::getenv("PUPFLOW_FAULT_REPORT");
  places_path = std::getenv("PUPFLOW_FAULT_PLACES");
  void* frame = nullptr;
  backtrace(&frame, 1);  // the first one takes memory
  char* end = nullptr;
  wanted = std::strtol(colon + 1, &end, 10);
  all_later = *end == '+';
  for (const Name& name : kNames) {
    if (std::strncmp(fault, name.text, static_cast<std::size_t>(colon - fault)) != 0) continue;
    if (name.text[colon - fault] != '\0') continue;
    chosen_error = name.error;
    chosen = name.kind;
  }
}

using Main = int (*)(int, char**, char**);
Main program_main = nullptr;

int counted_main(int count, char** words, char** environment) {
  begin();
  return program_main(count, words, environment);
}

[[gnu::destructor]] void end() {
  if (chosen == none) return;
  char text[64];
  std::snprintf(text, sizeof text, "count=%ld\n", calls.load());
  chosen = none;
  append(report_path, text);
}

template <std::size_t kCount>
bool lies_in(const void* address, const char* const (&libraries)[kCount]) {
  Dl_info info = {};
  if (dladdr(address, &info) == 0 || !info.dli_fname) return false;
  return std::any_of(libraries, libraries + kCount,
                     [&](const char* name) { return std::strstr(info.dli_fname, name); });
}

/// Whether a graphics driver asks, now: what it does without memory is its own affair. `caller` is
/// whoever called malloc: libgcc does so while it notes a driver's compiled code, and waits for
/// itself when it is then asked for its callers.
bool in_driver(const void* caller) {
  constexpr const char* kUnwinder[] = {"libgcc_s"};
  constexpr const char* kDrivers[] = {"_dri.so", "gallium", "LLVM",  "libEGL",
                                      "libGL",   "glapi",   "libdrm"};
  if (lies_in(caller, kUnwinder) || lies_in(caller, kDrivers)) return true;
  void* frames[64];
  const int count = backtrace(frames, 64);
  return std::any_of(frames, frames + count,
                     [&](const void* frame) { return lies_in(frame, kDrivers); });
}

/// Whether no allocation before had the same innermost callers.
bool is_new_place() {
  static std::atomic<std::uint64_t> seen[1 << 20];
  void* frames[7];  // three of them are this function, malloc and operator new
  const int count = backtrace(frames, std::size(frames));
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a
  for (int i = 0; i < count; ++i) {
    hash = (hash ^ reinterpret_cast<std::uintptr_t>(frames[i])) * 1099511628211u;
  }
  hash |= 1;
  for (std::size_t i = hash >> 44;; i = (i + 1) % std::size(seen)) {
    std::uint64_t there = 0;
    if (seen[i].compare_exchange_strong(there, hash)) return true;
    if (there == hash) return false;
  }
}

/// Counts a call; whether it is to fail, with errno set. `caller`: of an allocation.
bool fails(Kind kind, const void* caller = nullptr) {
  if (kind != chosen) return false;
  const long call = ++calls;
  if (kind == mallocs && places_path && !in_driver(caller) && is_new_place()) {
    char text[32];
    std::snprintf(text, sizeof text, "%ld\n", call);
    append(places_path, text);
  }
  if (wanted == 0 || (all_later ? call < wanted : call != wanted)) return false;
  if (kind == mallocs && in_driver(caller)) return false;
  if (call == wanted) append(report_path, "fired\n");
  errno = chosen_error;
  return true;
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int open_at(int folder, const char* path, int flags, mode_t mode) {
  if (fails(opens)) return -1;
  return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

mode_t mode_of(int flags, std::va_list rest) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
}

}  // namespace

extern "C" {

ssize_t read(int file, void* buffer, std::size_t size) {
  return fails(reads) ? -1 : syscall(SYS_read, file, buffer, size);
}
ssize_t pread(int file, void* buffer, std::size_t size, off_t at) {
  return fails(reads) ? -1 : syscall(SYS_pread64, file, buffer, size, at);
}
ssize_t pread64(int file, void* buffer, std::size_t size, off64_t at) {
  return fails(reads) ? -1 : syscall(SYS_pread64, file, buffer, size, at);
}
ssize_t write(int file, const void* buffer, std::size_t size) {
  if (fails(writes)) return -1;
  if (size > 1 && fails(shorts)) size = 1;
  return syscall(SYS_write, file, buffer, size);
}
ssize_t writev(int file, const iovec* parts, int count) {
  return fails(writes) ? -1 : syscall(SYS_writev, file, parts, count);
}
ssize_t pwrite(int file, const void* buffer, std::size_t size, off_t at) {
  return fails(pwrites) ? -1 : syscall(SYS_pwrite64, file, buffer, size, at);
}
ssize_t pwrite64(int file, const void* buffer, std::size_t size, off64_t at) {
  return fails(pwrites) ? -1 : syscall(SYS_pwrite64, file, buffer, size, at);
}
// What a fortified build calls where it knows the buffer's size.
ssize_t __read_chk(int file, void* buffer, std::size_t size, std::size_t) {
  return read(file, buffer, size);
}
int __open_2(const char* path, int flags) {
  return open_at(AT_FDCWD, path, flags, 0);
}
int __open64_2(const char* path, int flags) {
  return open_at(AT_FDCWD, path, flags, 0);
}
int fsync(int file) {
  return fails(syncs) ? -1 : static_cast<int>(syscall(SYS_fsync, file));
}
int fdatasync(int file) {
  return fails(syncs) ? -1 : static_cast<int>(syscall(SYS_fdatasync, file));
}
int rename(const char* from, const char* to) noexcept {
  return fails(renames) ? -1
                        : static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}
int renameat(int a, const char* from, int b, const char* to) noexcept {
  return fails(renames) ? -1 : static_cast<int>(syscall(SYS_renameat2, a, from, b, to, 0));
}
int renameat2(int a, const char* from, int b, const char* to, unsigned flags) noexcept {
  return fails(renames) ? -1 : static_cast<int>(syscall(SYS_renameat2, a, from, b, to, flags));
}
int mkdir(const char* path, mode_t mode) noexcept {
  return fails(mkdirs) ? -1 : static_cast<int>(syscall(SYS_mkdirat, AT_FDCWD, path, mode));
}
int close(int file) {  // as Linux does it: closed even when it fails
  const long done = syscall(SYS_close, file);
  return fails(closes) ? -1 : static_cast<int>(done);
}

#define PUPFLOW_OPEN(name)                       \
  int name(const char* path, int flags, ...) {   \
    std::va_list rest;                           \
    va_start(rest, flags);                       \
    const mode_t mode = mode_of(flags, rest);    \
    va_end(rest);                                \
    return open_at(AT_FDCWD, path, flags, mode); \
  }
PUPFLOW_OPEN(open)
PUPFLOW_OPEN(open64)
#define PUPFLOW_OPENAT(name)                               \
  int name(int folder, const char* path, int flags, ...) { \
    std::va_list rest;                                     \
    va_start(rest, flags);                                 \
    const mode_t mode = mode_of(flags, rest);              \
    va_end(rest);                                          \
    return open_at(folder, path, flags, mode);             \
  }
PUPFLOW_OPENAT(openat)
PUPFLOW_OPENAT(openat64)
FILE* fopen(const char* path, const char* mode) {
  return fails(opens) ? nullptr : next<FILE* (*)(const char*, const char*)>("fopen")(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  return fails(opens) ? nullptr : next<FILE* (*)(const char*, const char*)>("fopen64")(path, mode);
}

// HDF5 writes the time into its files; with a fixed one two runs give the same bytes.
time_t time(time_t* place) noexcept {
  constexpr time_t kTime = 1'000'000'000;
  if (chosen == none) return next<time_t (*)(time_t*)>("time")(place);
  return place ? *place = kTime : kTime;
}

int gettimeofday(timeval* place, void* zone) noexcept {
  if (chosen == none) return next<int (*)(timeval*, void*)>("gettimeofday")(place, zone);
  *place = {time(nullptr), 0};
  return 0;
}

void* malloc(std::size_t size) noexcept {
  return fails(mallocs, __builtin_return_address(0)) ? nullptr : __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails(mallocs, __builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  return fails(mallocs, __builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return fails(mallocs, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return fails(mallocs, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** place, std::size_t alignment, std::size_t size) noexcept {
  if (fails(mallocs, __builtin_return_address(0))) return ENOMEM;
  *place = __libc_memalign(alignment, size);
  return *place ? 0 : ENOMEM;
}

// Counting begins with main: before it C++ has nobody who could be told of a failure.
int __libc_start_main(Main main, int count, char** words, Main init, void (*fini)(),
                      void (*loader_fini)(), void* stack) {
  using Start = int (*)(Main, int, char**, Main, void (*)(), void (*)(), void*);
  program_main = main;
  return next<Start>("__libc_start_main")(counted_main, count, words, init, fini, loader_fini,
                                          stack);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                   void* argument) noexcept {
  using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);
  if (fails(threads)) return EAGAIN;
  return next<Create>("pthread_create")(thread, attributes, work, argument);
}

}  // extern "C"
