#include "files/number_pool.hpp"

#include "files/output.hpp"
#include "files/standard_streams.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>
#include <utility>

namespace mdm {
namespace {

constexpr std::size_t step = 16;                   // sizes of blocks are multiples of it
constexpr std::size_t longest = 128;               // bytes; longer blocks come from malloc
constexpr std::size_t bytes_cut_at_once = 1 << 14; // bytes cut into blocks at once

struct Block {
  Block *next;
};

/// Free blocks, a list for each size.
using Lists = std::array<Block *, longest / step + 1>;

/// The blocks that ended threads have left.
std::mutex orphans_mutex;
Lists orphans{};

/// A thread's lists. Without a destructor: an object with one is looked up behind a guard at every use.
constinit thread_local Lists own{};

/// Makes the lists of a thread that ends orphans.
struct AtThreadEnd {
  AtThreadEnd() = default;
  AtThreadEnd(const AtThreadEnd &) = delete;
  AtThreadEnd &operator=(const AtThreadEnd &) = delete;
  ~AtThreadEnd() {
    const std::lock_guard lock(orphans_mutex);
    for (std::size_t i = 0; i < own.size(); ++i) {
      Block *const first = std::exchange(own[i], nullptr);
      if (first == nullptr)
        continue;
      Block *last = first;
      while (last->next != nullptr)
        last = last->next;
      last->next = orphans[i];
      orphans[i] = first;
    }
  }
};

/// As GMP does: there is no way back from here, through C code that knows no exceptions.
[[noreturn]] void out_of_memory() {
  remove_unfinished();
  std::fprintf(stderr, "%s\n", out_of_memory_message);
  std::_Exit(2);
}

void *plain_allocate(std::size_t bytes) {
  void *const memory = std::malloc(bytes);
  if (memory == nullptr)
    out_of_memory();
  return memory;
}

std::size_t list_of(std::size_t bytes) {
  return (std::max<std::size_t>(bytes, 1) + step - 1) / step;
}

/// Fills an empty list. Kept out of allocate, which is called hundreds of times for each gradation.
[[gnu::noinline]] Block *refill(std::size_t list) {
  thread_local const AtThreadEnd at_thread_end;
  {
    const std::lock_guard lock(orphans_mutex);
    if (Block *const left = orphans[list]) { // no more than bytes_cut_at_once: the rest is for other threads
      Block *last = left;
      for (std::size_t n = 1; n < bytes_cut_at_once / (list * step) && last->next != nullptr; ++n)
        last = last->next;
      orphans[list] = std::exchange(last->next, nullptr);
      return left;
    }
  }
  const std::size_t bytes = list * step;
  std::byte *const memory = static_cast<std::byte *>(plain_allocate(bytes_cut_at_once));
  Block *first = nullptr;
  for (std::size_t at = 0; at + bytes <= bytes_cut_at_once; at += bytes)
    first = new (memory + at) Block{first};
  return first;
}

void *allocate(std::size_t bytes) {
  if (bytes > longest)
    return plain_allocate(bytes);
  Block *&list = own[list_of(bytes)];
  if (list == nullptr)
    list = refill(list_of(bytes));
  return std::exchange(list, list->next);
}

void release(void *memory, std::size_t bytes) {
  if (bytes > longest) {
    std::free(memory);
    return;
  }
  Block *&list = own[list_of(bytes)];
  list = new (memory) Block{list};
}

void *reallocate(void *memory, std::size_t before, std::size_t after) {
  if (before > longest && after > longest) {
    void *const moved = std::realloc(memory, after);
    if (moved == nullptr)
      out_of_memory();
    return moved;
  }
  if (before <= longest && after <= longest && list_of(before) == list_of(after))
    return memory;
  void *const moved = allocate(after);
  std::memcpy(moved, memory, std::min(before, after));
  release(memory, before);
  return moved;
}

} // namespace

#if defined(__SANITIZE_ADDRESS__)
#define MDM_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#define MDM_ADDRESS_SANITIZER __has_feature(address_sanitizer)
#else
#define MDM_ADDRESS_SANITIZER 0
#endif

void use_number_pool() {
  if (MDM_ADDRESS_SANITIZER == 0)
    mp_set_memory_functions(allocate, reallocate, release);
}

} // namespace mdm
