// A mass law by table from CSV. The first row may be the node (0, 0), which every law has; sizes and masses
// ascend. Each mistake is said with its line.

#include "gradation/csv_rows.hpp"
#include "gradation/shown.hpp"

#include <mdm/gradation/mass_law.hpp>
#include <mdm/gradation/read_gradation.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr std::string_view particle_mass = "particle_mass", law_header = "size_mm,particle_mass";

class TableReader {
public:
  TableReader(std::string_view content, const Source &source) : rows_(content, source), source_(source) {}

  MassLaw read() {
    rows_.read_header(law_header);
    if (rows_.size_name() != "size_mm" || rows_.fields().size() != 2 || rows_.fields()[1] != particle_mass)
      rows_.refuse(fmt::format("the columns of a mass law are {}: begin with this line", law_header));
    while (rows_.next())
      take({rows_.size(), rows_.number(particle_mass, 1)});
    if (law_.table.empty())
      source_.refuse(rows_.line(), "there is no node above size 0: give the mass of a particle of each size");
    return std::move(law_);
  }

private:
  void take(LawNode node) {
    const bool is_first = !has_row_;
    has_row_ = true;
    if (is_first && node.size == 0 && node.mass == 0)
      return;
    if (node.size <= 0 || node.mass <= 0)
      rows_.refuse(fmt::format("the node ({}, {}) is not above (0, 0), from which a mass law begins: give "
                               "sizes and masses above 0",
                               shown(node.size), shown(node.mass)));
    if (!law_.table.empty() && node.size <= law_.table.back().size)
      rows_.refuse(fmt::format("size {} is not above the {} before it: sort the rows, each size once",
                               shown(node.size), shown(law_.table.back().size)));
    if (!law_.table.empty() && node.mass <= law_.table.back().mass)
      rows_.refuse(fmt::format("particle_mass {} is not above the {} before it: a larger particle must have "
                               "more mass",
                               shown(node.mass), shown(law_.table.back().mass)));
    if (law_.table.size() == max_law_nodes)
      rows_.refuse(fmt::format("there are more than {} nodes: give fewer", max_law_nodes));
    law_.table.push_back(std::move(node));
  }

  CsvRows rows_;
  const Source &source_;
  bool has_row_ = false;
  MassLaw law_{1, 1};
};

} // namespace

MassLaw read_law_table(std::string_view csv, const std::string &file) {
  const Source source(file);
  const std::string_view text = without_byte_order_mark(csv);
  source.check_text(text, max_gradation_bytes);
  return TableReader(text, source).read();
}

} // namespace mdm
