#include "particles/packing_export.hpp"

#include "packing/packing_writer.hpp"
#include "particles/written_number.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <iterator>

namespace mdm {
namespace {

/// What is streamed is handed on in parts of some such length.
constexpr std::size_t part = std::size_t{1} << 16;

/// A file that is written.
class File {
public:
  File(const Packing &packing, SizeUnit unit, const Sink &out) : packing_(packing), unit_(unit), out_(out) {
    if (packing.unit.empty())
      return;
    const Rational factor = in_mm(parse_size_unit(packing.unit).value_or(unit)) / in_mm(unit);
    // Units are decimals of each other.
    Rational scaled = factor;
    while (denominator(scaled) != 1) {
      scaled *= 10;
      ++places_;
    }
    times_ = numerator(scaled);
  }
  ~File() { out_(text_); }
  File(const File &) = delete;
  File &operator=(const File &) = delete;

  /// A length of the packing as a decimal.
  std::string length(std::int64_t units) const {
    const Integer n = times_ * (units < 0 ? -units : units);
    return (units < 0 ? "-" : "") + decimal_string(n, packing_.places + places_);
  }
  /// `2650`, in kg per cube of the file's unit; in that of the packing where it has none.
  std::string density(const Rational &in_si) const {
    if (packing_.unit.empty())
      return short_decimal(in_si);
    constexpr int mm_of_m = 1000;
    return short_decimal(in_si * power(Rational(in_mm(unit_) / mm_of_m), 3));
  }
  /// What all files say above the discs.
  std::string title() const {
    const std::string lengths = packing_.unit.empty() ? "without a unit" : "in " + std::string(name(unit_));
    return fmt::format("{} discs that do not overlap, lengths {}, {}", packing_.discs.size(), lengths,
                       packing_.rule == DepositRule::apollonian ? "inside a circle"
                       : packing_.periodic                      ? "sides periodic"
                                                                : "sides walls");
  }

  template <class... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments &&...arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    if (text_.size() > part) {
      out_(text_);
      text_.clear();
    }
  }

private:
  const Packing &packing_;
  SizeUnit unit_;
  const Sink &out_;
  Integer times_ = 1;
  unsigned places_ = 0;
  std::string text_;
};

std::int64_t height(const Packing &p) {
  std::int64_t top = 0;
  for (const PackedDisc &d : p.discs)
    top = std::max(top, d.y + d.r);
  return top;
}

/// \param half the box in z
void write_data(const Packing &p, SizeUnit unit, const Rational &density, std::int64_t half,
                const std::string &how, const Sink &out) {
  File file(p, unit, out);
  const std::string rho = file.density(density);
  file.add(
      "{}; {}\n\n{} atoms\n1 atom types\n\n0 {} xlo xhi\n0 {} ylo yhi\n{} {} zlo zhi\n\nAtoms # sphere\n\n",
      file.title(), how, p.discs.size(), file.length(p.width), file.length(height(p)), file.length(-half),
      file.length(half));
  std::size_t id = 0;
  for (const PackedDisc &d : p.discs)
    file.add("{} 1 {} {} {} {} 0\n", ++id, file.length(2 * d.r), rho, file.length(d.x), file.length(d.y));
}

} // namespace

void write_packing_lammps(const Packing &p, SizeUnit unit, const Rational &density, const Sink &out) {
  write_data(
      p, unit, density, p.largest_radius() / 2,
      fmt::format("dimension 2, boundary {} f p, fix enforce2d, fix nve/sphere disc", p.periodic ? "p" : "f"),
      out);
}

void write_packing_liggghts(const Packing &p, SizeUnit unit, const Rational &density, const Sink &out) {
  write_data(p, unit, density, p.largest_radius(),
             fmt::format("a slab of spheres, boundary {} f p", p.periodic ? "p" : "f"), out);
}

void write_packing_yade(const Packing &p, SizeUnit unit, const Rational &density, const Sink &out) {
  File file(p, unit, out);
  file.add("# {}\n# density {} kg/m^3; for b in O.bodies: b.state.blockedDOFs = 'zXY'\n# x y z r\n",
           file.title(), short_decimal(density));
  for (const PackedDisc &d : p.discs)
    file.add("{} {} 0 {}\n", file.length(d.x), file.length(d.y), file.length(d.r));
}

void write_packing_lmgc90(const Packing &p, SizeUnit unit, const Rational &density, const Sink &out) {
  File file(p, unit, out);
  file.add(
      "# {}\n# density {} kg/m^3; r, x, y = numpy.loadtxt(FILE, unpack=True); pre.rigidDisk(r[i], [x[i], "
      "y[i]], ...)\n"
      "# radius x y\n",
      file.title(), short_decimal(density));
  for (const PackedDisc &d : p.discs)
    file.add("{} {} {}\n", file.length(d.r), file.length(d.x), file.length(d.y));
}

void write_packing_vtk(const Packing &p, SizeUnit unit, const Rational &, const Sink &out) {
  File file(p, unit, out);
  const std::size_t n = p.discs.size();
  file.add("# vtk DataFile Version 3.0\n{}\nASCII\nDATASET POLYDATA\nPOINTS {} double\n", file.title(), n);
  for (const PackedDisc &d : p.discs)
    file.add("{} {} 0\n", file.length(d.x), file.length(d.y));
  file.add("VERTICES {} {}\n", n, 2 * n);
  for (std::size_t i = 0; i < n; ++i)
    file.add("1 {}\n", i);
  file.add("POINT_DATA {}\nSCALARS radius double 1\nLOOKUP_TABLE default\n", n);
  for (const PackedDisc &d : p.discs)
    file.add("{}\n", file.length(d.r));
}

void write_packing_csv(const Packing &p, SizeUnit unit, const Rational &, const Sink &out) {
  File file(p, unit, out);
  const std::string in = p.unit.empty() ? "" : "_" + std::string(name(unit));
  file.add("x{0},y{0},radius{0},left,right\n", in);
  const auto support = [](std::int32_t s) {
    return s >= 0 ? std::to_string(s) : std::string(name(static_cast<Support>(s)));
  };
  for (const PackedDisc &d : p.discs)
    file.add("{},{},{},{},{}\n", file.length(d.x), file.length(d.y), file.length(d.r), support(d.left),
             support(d.right));
}

} // namespace mdm
