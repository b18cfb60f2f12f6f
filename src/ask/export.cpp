#include "particles/export_format.hpp"

#include <mdm/ask/export.hpp>
#include <mdm/text/error.hpp>

#include <ostream>

namespace mdm {
namespace {

/// PhasicFlow reads two files more.
bool is_one_file(const ExportFormat &format) {
  return format.id != ExportTo::phasicflow;
}

const ExportFormat &format_of_one_file(std::string_view name) {
  const ExportFormat *const format = find_export_format(name);
  if (format == nullptr)
    throw InputError(in_quotes(name) + " is no format: use one of " + export_format_names());
  if (!is_one_file(*format))
    throw InputError(in_quotes(name) + " is several files: write them with mdm export");
  return *format;
}

} // namespace

std::vector<std::string> export_formats() {
  std::vector<std::string> names;
  for (const ExportFormat &format : all_export_formats())
    if (is_one_file(format))
      names.emplace_back(format.name);
  return names;
}

void export_particles(const Match &m, std::string_view format, std::ostream &out,
                      const ExportOptions &options) {
  const ExportFormat &to = format_of_one_file(format);
  if (!m.sample)
    throw InputError("no match is known: there are no particles to write");
  if (options.density <= 0)
    throw InputError("the density is not above 0: give it in kg/m^3");
  ParticleSetOptions numbers;
  numbers.unit = options.unit;
  numbers.density = options.density;
  if (to.has_floats) {
    numbers.has_floats = true;
    numbers.most_mass_error = mass_error_of_floats();
  }
  const ParticleSet set = particle_set(m, numbers);
  const Sink sink = [&out](std::string_view text) {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  };
  if (to.write_placed != nullptr)
    to.write_placed(Placement(set, std::nullopt, options.seed), sink);
  else
    to.write(set, sink);
}

} // namespace mdm
