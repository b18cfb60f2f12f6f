#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <unordered_map>

namespace mdm {
namespace {

/// A model part (mdpa) of Kratos' DEM application: blocks from `Begin NAME` to `End NAME`, // comments. The
/// particles are the elements whose name begins with Spheric or Cylinder; Nodes have their places, and
/// NodalData RADIUS the radii of their nodes.
class KratosReader : public LineReader {
public:
  explicit KratosReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, SizeUnit::m);
  }

  void line(std::string_view text) override {
    split_words(text.substr(0, text.find("//")), words_);
    if (words_.empty())
      return;
    if (words_.front() == "Begin")
      begin();
    else if (words_.front() == "End")
      leave();
    else if (block_ == Block::nodes)
      read_node();
    else if (block_ == Block::particles)
      read_element();
    else if (block_ == Block::radii)
      read_radius();
  }

  void end() override {
    if (!open_.empty())
      source_.refuse("the file ends inside a block, without its End: is it cut off?");
    if (elements_ != radii_)
      source_.refuse(
          fmt::format("there are {} particles among the Elements, and {} values of NodalData RADIUS: put "
                      "one of them right",
                      elements_, radii_));
    for (const auto &[number, of] : nodes_)
      if (of.has_element && !of.has_radius)
        source_.refuse(
            fmt::format("the particle of node {} has no radius, and another node has one: put one of "
                        "them right",
                        number));
    source_.check_some();
  }

private:
  enum class Block { nodes, particles, radii, other };

  void begin() {
    if (words_.size() < 2)
      source_.refuse("a block without a name begins: write for example Begin Nodes");
    const bool has_more = words_.size() > 2;
    open_.emplace_back(words_[1]);
    block_ = Block::other;
    if (open_.size() > 1)
      return;
    if (words_[1] == "Nodes")
      block_ = Block::nodes;
    else if (words_[1] == "Elements" && has_more &&
             (words_[2].starts_with("Spheric") || words_[2].starts_with("Cylinder")))
      block_ = Block::particles;
    else if (words_[1] == "NodalData" && has_more && words_[2] == "RADIUS")
      block_ = Block::radii;
  }

  void leave() {
    if (open_.empty() || words_.size() < 2 || words_[1] != open_.back())
      source_.refuse("a block ends that did not begin, or another one is open: is the file damaged?");
    open_.pop_back();
    block_ = Block::other;
  }

  std::uint64_t number_of_node(std::size_t word) const {
    const std::optional<std::uint64_t> number =
        word < words_.size() ? parse_count(words_[word]) : std::nullopt;
    if (!number)
      source_.refuse("the number of a node is not a whole number: is the file damaged?");
    return *number;
  }

  void read_node() {
    const bool has_numbers = words_.size() == 4 && std::all_of(words_.begin(), words_.end(), is_number);
    if (!has_numbers)
      source_.refuse("the line is not a node's number with x y z: is the file damaged?");
    const Node read{{std::string(words_[1]), std::string(words_[2]), std::string(words_[3])}};
    if (!nodes_.emplace(number_of_node(0), read).second)
      source_.refuse(fmt::format("node {} is there a second time: leave one", words_[0]));
  }

  void read_element() {
    if (words_.size() != 3)
      source_.refuse(
          "the line is not a particle's number, its properties and its node: is the file damaged?");
    source_.take_id(words_[0]);
    Node &of = node(number_of_node(2));
    if (of.has_element)
      source_.refuse(fmt::format("node {} has a particle above: leave one", words_[2]));
    of.has_element = true;
    ++elements_;
  }

  void read_radius() {
    if (words_.size() != 3)
      source_.refuse("the line is not a node's number, 0 or 1, and a radius: is the file damaged?");
    Node &of = node(number_of_node(0));
    if (of.has_radius)
      source_.refuse(fmt::format("node {} has a radius above: leave one", words_[0]));
    of.has_radius = true;
    source_.particle_at({of.place[0], of.place[1], of.place[2]}, words_[2]);
    ++radii_;
  }

  struct Node {
    std::array<std::string, 3> place;
    bool has_element = false, has_radius = false;
  };

  Node &node(std::uint64_t number) {
    const auto found = nodes_.find(number);
    if (found == nodes_.end())
      source_.refuse(fmt::format("there is no node {} above: is the file damaged?", number));
    return found->second;
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  Block block_ = Block::other;
  std::vector<std::string> open_; ///< names of blocks: parts of a model are inside each other
  std::unordered_map<std::uint64_t, Node> nodes_;
  std::uint64_t elements_ = 0, radii_ = 0;
};

} // namespace

std::unique_ptr<LineReader> read_kratos(ParticleSource &source) {
  return std::make_unique<KratosReader>(source);
}

void write_kratos(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  LongText text(out);
  text.add("// {}\n// {}\nBegin ModelPartData\nEnd ModelPartData\n\nBegin Properties 0\nEnd "
           "Properties\n\nBegin Nodes\n",
           title(set), mass_statement(set));
  std::uint64_t node = 0;
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {} {}\n", ++node, start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]));
  });
  text.add("End Nodes\n\nBegin Elements SphericParticle3D\n");
  for (std::uint64_t element = 1; element <= node; ++element)
    text.add("{} 0 {}\n", element, element);
  text.add("End Elements\n\nBegin NodalData RADIUS\n");
  node = 0;
  start.each([&](const Placement::Sphere &s) { text.add("{} 0 {}\n", ++node, s.size->radius.text); });
  text.add("End NodalData\n");
  text.finish();
}

} // namespace mdm
