#include "cli/pack_sizes.hpp"

#include "ask/option_values.hpp"
#include "cli/packing_file.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "packing/set_discs.hpp"
#include "sets/matched_set.hpp"
#include "sets/set_sizes.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm::cli {
namespace {

/// As mdm generate has them.
constexpr unsigned size_digits = 15;

} // namespace

void PackSizes::add_to(CLI::App &command) {
  const auto option = [&command](const char *name, auto &value, const char *type, const char *help) {
    command.add_option(name, value, help)->type_name(type);
  };
  command.add_option(
      "FILE", file,
      "sizes that mdm generate --sizes wrote (CSV or JSON), or with --spread a gradation of discs "
      "(CSV, JSON, AGS4); - for standard input");
  option("--sizes", sizes, "FILE", "the same as FILE, sizes alone");
  command.add_flag(
      "--spread", spread,
      "FILE is a gradation: the discs of its smallest match with masses x^2, of a size each by --seed");
  option("--beta", beta, "A,B",
         "discs of the cumulative beta curve, a and b from 0.001 to 1000, drawn by --seed");
  option("--dmin", d_min, "SIZE", "smallest size of a beta curve (1 where --span or --ratio is alone)");
  option("--dmax", d_max, "SIZE", "largest size of a beta curve");
  option("--span", span, "S", "(dmax - dmin) / (dmax + dmin), between 0 and 1");
  option("--ratio", ratio, "R", "dmax / dmin, above 1");
  option("--classes", classes, "N", "number of size classes of a beta curve (10)");
  option("--classing", classing, "TEXT",
         "classes of equal widths (regular), ratios (geometric, the default) or volumes (isochoric)");
  option("--min-per-class", min_per_class, "N", "discs in the scarcest class (10; of a gradation 1)");
  option("--at-least", at_least, "N",
         "discs in all, of which the floors of Eq. 9 may lose some (2000; of a gradation 1)");
  reading.add_to(command);
}

bool PackSizes::is_given() const {
  return file || sizes || beta || d_min || d_max || span || ratio || reading.is_given() || classes ||
         classing || min_per_class || at_least || spread;
}

std::string PackSizes::source() const {
  return file ? *file : sizes.value_or("-");
}

DiscSizes PackSizes::read(std::uint64_t seed) const {
  if (file.has_value() + sizes.has_value() + beta.has_value() != 1)
    throw InputError("give the discs in one way: FILE, --sizes or --beta");
  if (!beta && (d_min || d_max || span || ratio || classes || classing))
    throw InputError(
        "--dmin, --dmax, --span, --ratio, --classes and --classing are of --beta: add it or leave "
        "them out");
  if (spread && !file)
    throw InputError("--spread: it is of a gradation: give its FILE");
  if (!spread && !beta && (min_per_class || at_least))
    throw InputError("--min-per-class and --at-least: the file has its discs: leave them out");
  return beta ? of_curve(seed) : of_file(source(), seed);
}

DiscSizes PackSizes::of_curve(std::uint64_t seed) const {
  BetaOptions options = *this;
  if (!d_min && !d_max)
    options.d_min = "1";
  const std::string how = classing.value_or("geometric");
  if (how != "regular" && how != "geometric" && how != "isochoric")
    throw InputError("--classing: " + in_quotes(how) + " is unknown: use regular, geometric or isochoric");
  const Integer n = natural("classes", classes.value_or("10"), 1);
  if (n > max_size_classes)
    throw InputError("--classes: " + to_string(n) + " is too large: at most " +
                     std::to_string(max_size_classes));
  const std::shared_ptr<const BetaCurve> curve = beta_curve(options);
  const std::vector<SizeClass> all = size_classes(*curve,
                                                  how == "regular"     ? Classing::regular
                                                  : how == "geometric" ? Classing::geometric
                                                                       : Classing::isochoric,
                                                  static_cast<unsigned>(n));
  const ClassCounts counts = class_counts(all, *curve,
                                          {natural("min-per-class", min_per_class.value_or("10"), 1),
                                           natural("at-least", at_least.value_or("2000"), 1), 2});
  if (!counts.decided())
    throw InputError("--beta: the numbers of discs are not decided by 4096 bits: change a size a little");
  if (counts.particles() > most_discs)
    throw InputError("--beta: " + to_string(counts.particles()) +
                     " discs are more than 10^7: ask for fewer, for fewer classes or for a smaller span");
  return set_discs(drawn_particles(all, counts.numbers, 2, size_digits, Draws::random(seed)), all.size(),
                   beta_unit(options));
}

DiscSizes PackSizes::of_file(const std::string &path, std::uint64_t seed) const {
  const std::string content = read_file(path, most_packing_bytes), name = shown_name(path);
  if (spread)
    return of_gradation(content, name, seed);
  if (!has_disc_sizes(content))
    throw InputError(printable(name) +
                     ": no sizes of discs: write them with mdm generate --dimension 2 --sizes "
                     "--format csv, or add --spread to a gradation");
  return read_disc_sizes(content, name);
}

DiscSizes PackSizes::of_gradation(const std::string &content, const std::string &name,
                                  std::uint64_t seed) const {
  const Gradation g = read_gradation(content, name, reading.reading());
  Representativity wanted;
  wanted.min_per_class = natural("min-per-class", min_per_class.value_or("1"), 1);
  wanted.at_least = natural("at-least", at_least.value_or("1"), 1);
  wanted.dimension = 2;
  SolveOptions options;
  options.at_most = Integer(most_discs);
  const Match m = matched_set(g.has_factors() ? by_volume(g) : g, wanted, options);
  if (!m.complete)
    throw InputError(printable(name) + ": its smallest match of discs was not found, or has more than 10^7: "
                                       "leave out fine classes");
  if (*m.particles() > most_discs)
    throw InputError(printable(name) + ": its smallest match has " + to_string(*m.particles()) +
                     " discs, more than 10^7: leave out fine classes");
  DiscSizes discs =
      set_discs(spread_particles(m, seed), m.gradation.classes(), std::string(mdm::name(m.gradation.unit())));
  discs.notes = g.notes();
  return discs;
}

} // namespace mdm::cli
