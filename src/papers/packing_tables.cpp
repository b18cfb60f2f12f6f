#include "papers/packing_tables.hpp"

#include "packing/contacts.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <iterator>

namespace mdm {
namespace {

constexpr unsigned packing_digits = 10;
/// Of what is a mean of enclosures with 15 packing_digits.
constexpr unsigned fraction_places = 15;

/// `lo,hi`, rounded outwards.
std::string cells(const Interval &i) {
  const Rational unit(power_of_ten(fraction_places));
  return decimal_string(floor(Rational(i.lo * unit)), fraction_places) + "," +
         decimal_string(ceil(Rational(i.hi * unit)), fraction_places);
}

std::string cells(const Shape &shape, Classing classing, const Rational &span) {
  return fmt::format("{},{},{},{}", to_decimal(shape.a), to_decimal(shape.b),
                     classing == Classing::regular ? "regular" : "geometric", to_decimal(span));
}

std::string share(const Integer &some, const Integer &all) {
  return all == 0 ? "" : rounded(Real(ratio(some, all)), packing_digits);
}

std::string cells(const CellCounts &c) {
  const Integer all = c.total();
  return fmt::format("{},{},{},{}", share(c.triangles, all), share(c.quadrangles, all),
                     share(c.pentagons, all), share(c.larger, all));
}

std::string note(const PackingPoint &p, const Integer &most) {
  if (!p.deposits.empty())
    return "";
  return p.discs ? "left out: more than " + to_string(most) + " discs"
                 : "left out: the number of discs is not decided by 4096 bits";
}

} // namespace

std::string gasket_table(const ApollonianGasket &gasket, const Rational &most) {
  std::string text = "p,q,radius,x,y\n";
  gasket.each(most, [&](const ApollonianCircle &c) {
    text +=
        fmt::format("{},{},{},{},{}\n", c.p, c.q, rounded(Real(1) / gasket.curvature(c), packing_digits),
                    rounded(gasket.centre_x(c), packing_digits), rounded(gasket.centre_y(c), packing_digits));
  });
  return text;
}

std::string figure9_table(const PackingStudy &study) {
  std::string text =
      "a,b,classing,span,discs,deposits,fraction_lo,fraction_hi,scatter_lo,scatter_hi,coordination,"
      "touching_3,touching_4,touching_5,triangles,quadrangles,pentagons,larger_cells,note\n";
  for (const PackingPoint &p : study.points) {
    text += fmt::format("{},{},{},", cells(p.shape, p.classing, p.span), p.discs ? to_string(*p.discs) : "",
                        p.deposits.size());
    if (p.deposits.empty())
      text += ",,,,,,,,,,,,";
    else
      text += fmt::format("{},{},{},{},{},{},{},", cells(p.mean()), cells(p.scatter()),
                          rounded(Real(p.coordination()), packing_digits),
                          rounded(Real(p.touching(3)), packing_digits),
                          rounded(Real(p.touching(4)), packing_digits),
                          rounded(Real(p.touching(5)), packing_digits), cells(p.cells()));
    text += note(p, study.terms.at_most) + "\n";
  }
  return text;
}

std::string deposits_table(const std::vector<PackingPoint> &points) {
  std::string text =
      "a,b,classing,span,seed,width_factor,discs,fraction_lo,fraction_hi,contacts,outer_supports,"
      "triangles,quadrangles,pentagons,larger_cells\n";
  for (const PackingPoint &p : points)
    for (std::size_t i = 0; i < p.deposits.size(); ++i) {
      const DepositFacts &d = p.deposits[i];
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", cells(p.shape, p.classing, p.span), i + 1,
                          to_decimal(width_factor(i + 1)), d.discs, cells(d.fraction), d.contacts,
                          d.outer_supports, d.cells.triangles, d.cells.quadrangles, d.cells.pentagons,
                          d.cells.larger);
    }
  return text;
}

std::string discs_table(const std::vector<Snapshot> &snapshots) {
  std::string text = "span,x,y,radius,contacts\n";
  for (const Snapshot &s : snapshots) {
    const PackingContacts contacts = packing_contacts(s.packing);
    const std::string span = to_decimal(s.span);
    for (std::size_t i = 0; i < s.packing.discs.size(); ++i) {
      const PackedDisc &d = s.packing.discs[i];
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{}\n", span, s.packing.text(d.x),
                     s.packing.text(d.y), s.packing.text(d.r), contacts.of_disc[i]);
    }
  }
  return text;
}

std::string cells_table(const Packing &packing) {
  std::string text = "corners,discs\n";
  each_cell(packing, packing_contacts(packing), [&text](const std::vector<CellCorner> &corners) {
    text += std::to_string(corners.size()) + ",";
    const char *space = "";
    for (const CellCorner &c : corners) {
      text += space + std::to_string(c.disc);
      space = " ";
    }
    text += "\n";
  });
  return text;
}

} // namespace mdm
