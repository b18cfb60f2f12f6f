// VTK's XML: the points of ParaView's and of LIGGGHTS' files. The lines are gathered, and read as a tree at
// the end. Each piece has its points and, below PointData, an array for each of their properties.

#include "gradation/xml_tree.hpp"
#include "particles/line_reader.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

using Words = std::vector<std::string_view>;

class VtpReader : public LineReader {
public:
  explicit VtpReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::diameter, SizeUnit::m);
  }

  void line(std::string_view text) override {
    constexpr std::size_t most_bytes = std::size_t{1} << 30;
    if (text.size() > most_bytes - text_.size())
      source_.refuse("the file is longer than 1 GiB, which is not read: write it as a dump or as CSV");
    begins_.push_back(text_.size());
    text_ += text;
    text_ += '\n';
  }

  void end() override {
    const XmlTree tree(std::move(text_), Source(source_.file()), "the file");
    const pugi::xml_node root = tree.root();
    const std::string_view type = root.attribute("type").value();
    if (local_name(root.name()) != "VTKFile" || !(type == "PolyData" || type == "UnstructuredGrid"))
      refuse(root, "it is not the XML of VTK's points: write a VTKFile of type PolyData or UnstructuredGrid");
    for (const pugi::xml_node piece : only_child(root, type).children("Piece"))
      read_piece(piece);
    source_.check_some();
  }

private:
  /// Names the line where the tag of the node begins.
  [[noreturn]] void refuse(pugi::xml_node node, const std::string &what) {
    set_line_of(node);
    source_.refuse(what);
  }

  void set_line_of(pugi::xml_node node) {
    const auto at = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
    source_.set_line(
        static_cast<std::uint64_t>(std::upper_bound(begins_.begin(), begins_.end(), at) - begins_.begin()));
  }

  /// The child of that name; none where there is none.
  pugi::xml_node only_child(pugi::xml_node of, std::string_view name) {
    const pugi::xml_node child = child_of(of, name);
    for (pugi::xml_node next = child.next_sibling(); next; next = next.next_sibling())
      if (local_name(next.name()) == name)
        refuse(next, fmt::format("{} is there a second time: leave one", name));
    return child;
  }

  /// The array of that name; none where there is none.
  pugi::xml_node array(pugi::xml_node of, std::string_view name) {
    pugi::xml_node found;
    for (const pugi::xml_node node : of.children("DataArray"))
      if (node.attribute("Name").value() == name) {
        if (found)
          refuse(node, "there are several arrays " + in_quotes(name) + ": leave one");
        found = node;
      }
    return found;
  }

  /// The numbers of an array, so many for each point.
  Words numbers(pugi::xml_node array, std::uint64_t points, std::uint64_t of_point) {
    const std::string name = "the array " + in_quotes(array.attribute("Name").value());
    if (std::string_view(array.attribute("format").value()) != "ascii")
      refuse(array, name + " is not ASCII: write the file with the data mode Ascii");
    Words words;
    const auto texts = array.children();
    if (std::count_if(texts.begin(), texts.end(),
                      [](pugi::xml_node n) { return n.type() == pugi::node_pcdata; }) > 1)
      refuse(array, name + " has a comment, or another tag, among its numbers: leave the numbers alone");
    std::string_view rest = array.child_value();
    while (!(rest = rest.substr(std::min(rest.find_first_not_of(" \t\n"), rest.size()))).empty()) {
      const std::size_t end = std::min(rest.find_first_of(" \t\n"), rest.size());
      words.push_back(rest.substr(0, end));
      rest.remove_prefix(end);
    }
    if (words.size() != points * of_point)
      refuse(array, fmt::format("{} has {} numbers, and {} points have {}: is the file damaged?", name,
                                words.size(), points, points * of_point));
    return words;
  }

  /// The array of sizes, of that meaning; no array where it is not asked for.
  pugi::xml_node sizes(pugi::xml_node data, SizeMeaning meaning) {
    const std::optional<std::string> &named = source_.options().size_column;
    if (named)
      return source_.options().meaning == meaning ? array(data, *named) : pugi::xml_node();
    return array(data, meaning == SizeMeaning::radius ? "radius" : "diameter");
  }

  /// The array of classes, as mdm export or an engine calls it.
  pugi::xml_node type_of(pugi::xml_node data) {
    const pugi::xml_node classes = array(data, "class");
    return classes ? classes : array(data, "type");
  }

  void read_piece(pugi::xml_node piece) {
    const std::optional<std::uint64_t> points = parse_count(piece.attribute("NumberOfPoints").value());
    if (!points)
      refuse(piece, "the piece has no NumberOfPoints: is the file damaged?");
    const pugi::xml_node data = only_child(piece, "PointData");
    if (*points == 0) // of a process without particles
      return check_empty(data);
    const pugi::xml_node radius = sizes(data, SizeMeaning::radius),
                         diameter = sizes(data, SizeMeaning::diameter), id = array(data, "id"),
                         type = type_of(data);
    if (!radius && !diameter)
      refuse(piece, "the points of the piece have no array radius or diameter: write one below PointData, or "
                    "name it with " +
                        option("size-column"));
    if (radius && diameter && source_.options().meaning)
      refuse(piece, fmt::format("there are arrays radius and diameter, of which {} and {} choose none: leave "
                                "one out",
                                option("radius"), option("diameter")));
    source_.set_defaults(radius ? SizeMeaning::radius : SizeMeaning::diameter, SizeUnit::m);
    const Words sizes = numbers(radius ? radius : diameter, *points, 1),
                others = radius && diameter ? numbers(diameter, *points, 1) : Words(),
                ids = id ? numbers(id, *points, 1) : Words(),
                types = type ? numbers(type, *points, 1) : Words(), places = places_of(piece, *points);
    set_line_of(radius ? radius : diameter);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      if (!ids.empty())
        source_.take_id(ids[i]);
      if (!types.empty())
        source_.take_class(types[i]);
      if (!others.empty())
        source_.check_agree(sizes[i], others[i]);
      source_.particle_at({places[3 * i], places[3 * i + 1], places[3 * i + 2]}, sizes[i]);
    }
  }

  void check_empty(pugi::xml_node data) {
    for (const pugi::xml_node array : data.children("DataArray"))
      if (std::string_view(array.attribute("format").value()) == "ascii")
        numbers(array, 0, 1);
  }

  Words places_of(pugi::xml_node piece, std::uint64_t points) {
    const pugi::xml_node array = only_child(only_child(piece, "Points"), "DataArray");
    if (!array)
      refuse(piece, "the piece has no Points: is the file damaged?");
    return numbers(array, points, 3);
  }

  ParticleSource &source_;
  std::string text_;                ///< of the file
  std::vector<std::size_t> begins_; ///< of its lines
};

} // namespace

std::unique_ptr<LineReader> read_vtp(ParticleSource &source) {
  return std::make_unique<VtpReader>(source);
}

} // namespace mdm
