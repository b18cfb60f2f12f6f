#include "cli/soil_flags.hpp"

#include "cli/option_tables.hpp"

namespace mdm::cli {

void SoilFlags::add_to(CLI::App &command) {
  add_options(command, options, *this);
}

} // namespace mdm::cli
