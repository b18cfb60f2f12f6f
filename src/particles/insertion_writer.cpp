#include "particles/liggghts_insertion.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// Primes above 10000, each once: LIGGGHTS takes no other seeds, and none twice.
class Seeds {
public:
  explicit Seeds(std::uint64_t seed) : last_(10000 * (1 + seed % 200000)) {}

  std::uint64_t next() {
    do
      ++last_;
    while (!is_prime(last_));
    return last_;
  }

private:
  static bool is_prime(std::uint64_t n) {
    for (std::uint64_t d = 2; d * d <= n; ++d)
      if (n % d == 0)
        return false;
    return true;
  }

  std::uint64_t last_;
};

/// Text for a comment of a script, without what the script's reader looks for even there.
std::string script_words(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '"' || c == '$' || c == '&' || c == '\\'; }, '_');
  return text;
}

/// Sizes from the largest down.
template <class Take>
void each_size(const ParticleSet &set, Take take) {
  for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c)
    for (auto size = c->sizes.rbegin(); size != c->sizes.rend(); ++size)
      take(*c, *size);
}

} // namespace

void add_liggghts_insertion(const ParticleSet &set, std::uint64_t seed, LongText &text) {
  check_simulated(set);
  // LIGGGHTS refuses volumes below 1e-12, sizes below 0.124 mm, unless told otherwise.
  const std::string limit = approximate(Rational(power(set.smallest().diameter.decimal(), 3) / 1000), 2);
  text.add("\nvariable mdm_count equal count(all)\n");
  Seeds seeds(seed);
  Integer total = 0;
  each_size(set, [&](const ParticleClass &c, const ParticleSize &size) {
    const bool is_largest = total == 0;
    total += size.quantity;
    const std::string name = is_largest ? "mdm_largest" : "mdm_size";
    text.add("\n# {}: {} of radius {}\n", c.text(), to_string(size.quantity), size.radius.text);
    text.add("fix {} all particletemplate/sphere {} atom_type 1 volume_limit {} density constant {} radius "
             "constant {}\n",
             name, seeds.next(), limit, short_decimal(c.density), size.radius.text);
    text.add("fix mdm_sizes all particledistribution/discrete/numberbased {} {}\n", seeds.next(),
             is_largest ? "1 mdm_largest 1" : "2 mdm_size 1 mdm_largest 0");
    text.add("fix mdm_insertion all insert/pack seed {} distributiontemplate mdm_sizes maxattempt 500 "
             "insert_every once overlapcheck yes all_in yes vel constant 0 0 0 region mdm_region "
             "particles_in_region {}\nrun 1\n",
             seeds.next(), to_string(total));
    text.add(
        "if \"${{mdm_count}} != {}\" then \"print 'STOP: class {}: ${{mdm_count}} particles are there, not "
        "{}: make mdm_region larger'\" quit\nunfix mdm_insertion\nunfix mdm_sizes\n",
        to_string(total), c.number, to_string(total));
    if (!is_largest)
      text.add("unfix mdm_size\n");
  });
}

void write_liggghts(const ParticleSet &set, const Sink &out) {
  LongText text(out);
  text.add("# {}\n# {}\n", script_words(title(set)), mass_statement(set));
  text.add(R"(#
# Insertion for LIGGGHTS, to be included where a model without particles has a region called mdm_region:
#   include THIS_FILE
# It stops with a message where a count is not reached: the region is too small then. One template and one insertion
# a size, largest first, the count given as the running total. The largest template takes part with weight 0: insert/pack
# looks for overlaps with grains up to the largest of its distribution alone. Seeds are distinct primes.
)");
  add_liggghts_insertion(set, 0, text);
  text.finish();
}

void write_mercurydpm(const ParticleSet &set, const Sink &out) {
  const Integer all = set.particles();
  LongText text(out);
  text.add(
      "radius_{},cumulative_number,{} particles: {}. {} MercuryDPM draws sizes at random from these shares: "
      "its counts "
      "are not exact. Read with setPSDFromCSV(file; CUMULATIVE_NUMBER_DISTRIBUTION; true): the first row "
      "is a heading.\n",
      name(set.unit), to_string(all), title(set), mass_statement(set));
  Integer below = 0;
  for (const ParticleClass &c : set.classes)
    for (const ParticleSize &size : c.sizes) {
      text.add("{},{}\n", size.radius.text, short_decimal(ratio(below, all)));
      below += size.quantity;
      text.add("{},{}\n", size.radius.text, short_decimal(ratio(below, all)));
    }
  text.finish();
}

} // namespace mdm
