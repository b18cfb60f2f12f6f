#include "packing/packing_writer.hpp"

#include <fmt/format.h>

#include <iterator>

namespace mdm {
namespace {

/// What is streamed is handed on in parts of some such length.
constexpr std::size_t part = std::size_t{1} << 16;

void append_support(std::string &text, std::int32_t support) {
  if (support >= 0)
    fmt::format_to(std::back_inserter(text), " {}", support);
  else
    text.append(" ").append(name(static_cast<Support>(support)));
}

} // namespace

std::string_view name(Support support) {
  return support == on_floor        ? "floor"
         : support == on_left_wall  ? "left-wall"
         : support == on_right_wall ? "right-wall"
                                    : "none";
}

std::string_view name(DepositRule rule) {
  return rule == DepositRule::lowest ? "lowest" : rule == DepositRule::drop ? "drop" : "apollonian";
}

std::string_view name(FloorRule rule) {
  return rule == FloorRule::left ? "left" : "centred";
}

void write_packing(const Packing &p, const Sink &out) {
  std::string text =
      fmt::format("mdm-packing 1\nunit {}\nplaces {}\nwidth {}\nsides {}\nrule {}\nfloor {}\nseed {}\n"
                  "front {}\nradii {}\ndiscs {}\nx y r left right\n",
                  p.unit.empty() ? "any" : p.unit, p.places, p.width, p.periodic ? "periodic" : "walls",
                  name(p.rule), name(p.floor), p.seed, p.front, p.radii_hash(), p.discs.size());
  for (const PackedDisc &d : p.discs) {
    fmt::format_to(std::back_inserter(text), "{} {} {}", d.x, d.y, d.r);
    append_support(text, d.left);
    append_support(text, d.right);
    text += '\n';
    if (text.size() > part) {
      out(text);
      text.clear();
    }
  }
  out(text);
}

} // namespace mdm
