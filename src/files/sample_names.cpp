#include "files/sample_names.hpp"

#include "files/paths.hpp"

#include <fmt/format.h>

#include <map>

namespace mdm {

void tell_apart(const std::vector<std::string *> &names, const std::vector<std::string> &files) {
  std::map<std::string, unsigned> count, given;
  for (const std::string *name : names)
    ++count[*name];
  for (std::size_t i = 0; i < names.size(); ++i) {
    const unsigned number = ++given[files[i]];
    if (count[*names[i]] > 1)
      *names[i] = number == 1 ? shown_name(files[i]) : fmt::format("{} ({})", shown_name(files[i]), number);
  }
}

} // namespace mdm
