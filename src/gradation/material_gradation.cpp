// Gradations of several materials. What comes in is a table whose rows name their material; what goes out is
// a gradation with the rows of one material behind those of another. Each material's rows are first made a
// gradation of their own, by the rules of any other, so that each is complete by itself.

#include "gradation/material_gradation.hpp"

#include "gradation/csv_reader.hpp"
#include "gradation/table.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <map>

namespace mdm {
namespace {

/// The rows of each material, by its name.
std::map<std::string, Table> by_material(const Table &all) {
  std::map<std::string, Table> parts;
  for (std::size_t row = 0; row < all.sizes.size(); ++row) {
    Table &part = parts[all.materials[row]];
    if (part.sizes.empty()) {
      part.column = all.column;
      part.unit = all.unit;
      part.file_unit = all.file_unit;
      part.root = all.root;
      part.header_line = all.lines[row];
    }
    part.sizes.push_back(all.sizes[row]);
    part.values.push_back(all.values[row]);
    part.lines.push_back(all.lines[row]);
    if (!all.factors.empty())
      part.factors.push_back(all.factors[row]);
  }
  return parts;
}

Gradation part_of(const std::string &material, Table rows, const Source &source) {
  try {
    return to_gradation(std::move(rows), source);
  } catch (const InputError &error) {
    throw InputError(std::string(error.what()) + " (of the material " + in_quotes(material) + ")");
  }
}

} // namespace

Gradation joined(std::vector<Material> parts, const std::string &id) {
  Gradation all = std::move(parts.front().gradation);
  all.data_.id = id;
  all.materials_ = {{std::move(parts.front().name), 0, all.powers().size()}};
  const auto append = [](std::vector<Rational> &column, const std::vector<Rational> &more) {
    column.insert(column.end(), more.begin(), more.end());
  };
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Gradation::Data &part = parts[i].gradation.data_;
    const std::size_t begin = all.powers().size();
    append(all.data_.sizes, part.sizes);
    append(all.data_.masses, part.masses);
    append(all.data_.factors, part.factors);
    all.materials_.push_back({std::move(parts[i].name), begin, all.powers().size()});
  }
  return all;
}

const MaterialRows *find_material(const Gradation &g, std::string_view name) {
  const auto found =
      std::lower_bound(g.materials().begin(), g.materials().end(), name,
                       [](const MaterialRows &rows, std::string_view n) { return rows.name < n; });
  return found == g.materials().end() || found->name != name ? nullptr : &*found;
}

bool is_material_gradation(std::string_view content) {
  return is_material_csv(without_byte_order_mark(content));
}

Gradation read_material_gradation(std::string_view content, const std::string &file) {
  const Source source(file);
  const std::string_view text = without_byte_order_mark(content);
  source.check_length(content, max_gradation_bytes);
  source.check_text(text, max_gradation_bytes);
  const Table all = read_material_csv(text, source, stem(file));
  if (all.sizes.empty())
    source.refuse(all.header_line, "there is no row below the header: give the sieves of each material");
  std::vector<Material> parts;
  for (auto &[name, rows] : by_material(all)) {
    if (parts.empty())
      rows.notes = all.notes;
    parts.push_back({name, part_of(name, std::move(rows), source)});
  }
  return joined(std::move(parts), stem(file));
}

void refuse_beside_materials(const std::string &given, const std::string &file) {
  if (!given.empty())
    throw InputError(given + ": it is of gradations of one material, and " + printable(file) +
                     " has several: leave it out");
}

} // namespace mdm
