#include "cli/regrading_flags.hpp"

#include "cli/help.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"

namespace mdm::cli {

void RegradingFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "Changes in this order");
  command
      .add_option("--join", join,
                  "two analyses of one sample: sieves above the joint, the other, as of a hydrometer, below")
      ->type_name("COARSE FINE")
      ->expected(2);
  command
      .add_option("--split", split,
                  "composite sieving: FINE is a part of what passed the finest sieve of COARSE")
      ->type_name("COARSE FINE")
      ->expected(2);
  command.add_option("--at", at, "where the two are joined, a sieve of both")->type_name("SIZE");
  command
      .add_option("--fine-mass", fine_mass,
                  "of --split: the mass of all that passed, where COARSE has no row for its pan")
      ->type_name("MASS");
  command.add_option("--scalp", scalp, "leave out the grains above a sieve")->type_name("above:SIZE");
  command
      .add_option("--replace", replace,
                  "replace the grains above a sieve by as much mass between two, in the shares there")
      ->type_name("above:SIZE into FROM..TO")
      ->expected(3);
  command.add_option("--parallel", parallel_ratio, "the parallel gradation: all sizes times R, as 1/5")
      ->type_name("R");
}

Regraded RegradingFlags::joined_files(const ReadingFlags &reading, bool quiet) const {
  const auto part = [&](std::size_t i) {
    return any_gradation(files()[i], reading, quiet, PhiReading::rounded);
  };
  const UnderstoodGradation coarse = part(0), fine = part(1);
  return joined_parts(coarse, fine, {shown_name(files()[0]), shown_name(files()[1])});
}

} // namespace mdm::cli
