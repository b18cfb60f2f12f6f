// Programs of the user's, of a program that cannot run any: WebAssembly.
#include "files/child_process.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

ChildEnd run_child(const std::string &, std::string_view, std::chrono::milliseconds, std::size_t) {
  throw InputError("this mdm runs no other programs: use mdm of the command line");
}

} // namespace mdm
