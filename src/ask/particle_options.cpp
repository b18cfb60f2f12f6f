#include "ask/particle_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

ParticleOptions ParticleTexts::options(SizeUnit target) const {
  ParticleOptions o;
  o.target = target;
  o.says_otherwise = option("radius") + ", " + option("diameter") + " and " + option("size-unit") + " say";
  if (from)
    o.format = parse_particle_format(*from);
  if (from && !o.format)
    throw InputError(option("from") + ": " + in_quotes(*from) + " is no format: use one of " +
                     particle_format_names());
  if (radius || diameter)
    o.meaning = radius ? SizeMeaning::radius : SizeMeaning::diameter;
  if (size_unit)
    o.unit = length_unit_of("size-unit", *size_unit);
  if (timestep)
    o.timestep = natural("timestep", *timestep, 0);
  return o;
}

} // namespace mdm
