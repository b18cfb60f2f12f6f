#include "files/open_files.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>
#include <sys/resource.h>

namespace mdm {

void allow_open_files(std::size_t shards) {
  const rlim_t needed = 2 * shards + 20; // and those of the program itself
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= needed)
    return;
  if (limit.rlim_max < needed)
    throw InputError(
        fmt::format("mdm: {} shards are up to {} open files, and the system allows {}: raise it, as "
                    "with ulimit -n, or solve the suite in fewer shards",
                    shards, needed, limit.rlim_max));
  limit.rlim_cur = needed;
  setrlimit(RLIMIT_NOFILE, &limit);
}

} // namespace mdm
