// Programs of the user's, which are words for /bin/sh: Windows has none.
#include "files/child_process.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

ChildEnd run_child(const std::string &, std::string_view, std::chrono::milliseconds, std::size_t) {
  throw InputError("on Windows mdm runs no other programs: use mdm of Linux, as in WSL");
}

} // namespace mdm
