#include "ask/export_packing.hpp"

#include "particles/packing_export.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

struct PackingFormat {
  const char *name;
  void (*write)(const Packing &, SizeUnit, const Rational &, const Sink &);
};

constexpr std::array<PackingFormat, 6> packing_formats = {{{"lammps", write_packing_lammps},
                                                           {"liggghts", write_packing_liggghts},
                                                           {"yade", write_packing_yade},
                                                           {"lmgc90", write_packing_lmgc90},
                                                           {"vtk", write_packing_vtk},
                                                           {"csv", write_packing_csv}}};

} // namespace

void export_packing(const Packing &packing, const std::string &format, SizeUnit unit, const Rational &density,
                    const Sink &sink) {
  const auto found = std::find_if(packing_formats.begin(), packing_formats.end(),
                                  [&format](const PackingFormat &f) { return format == f.name; });
  if (found == packing_formats.end())
    throw InputError(option("to") + ": " + in_quotes(format) +
                     " takes no packings of discs: use lammps, liggghts, yade, lmgc90, vtk or csv");
  found->write(packing, unit, density, sink);
}

} // namespace mdm
