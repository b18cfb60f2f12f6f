// export_particles GRADATION FORMAT OUT: the smallest match as a file for a DEM code, such as lammps or yade.

#include <mdm/mdm.hpp>

#include <fstream>
#include <iostream>

int main(int argc, char **argv) try {
  if (argc != 4)
    throw mdm::InputError("give a gradation, a format and a file to write");
  const mdm::Match match = mdm::solve(mdm::read_gradation_file(argv[1]));
  mdm::ExportOptions options;
  options.unit = mdm::SizeUnit::m;
  options.density = 2650; // kg/m^3
  std::ofstream out(argv[3], std::ios::binary);
  mdm::export_particles(match, argv[2], out, options);
  out.close();
  std::cout << match.particles().value() << " particles in " << argv[3] << '\n';
  return out ? 0 : 2;
} catch (const mdm::InputError &e) {
  std::cerr << e.what() << '\n';
  return 2;
}
