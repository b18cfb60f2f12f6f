#include "certificate.hpp"

#include "question_lines.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace mdm::checker {
namespace {

// Limit 5.
constexpr std::size_t most_of_tree = std::size_t{1} << 22U;

/// The lines of a certificate of a match, or of none.
class Lines : public QuestionLines {
public:
  explicit Lines(std::string_view text) : QuestionLines(text, "mdm solve") {}

  /// One class, or with version 2 those from i to j, written i-j.
  ClassRange classes(unsigned version) { return classes(word(), version); }
  /// The letters of conditions of all classes, of single ones, and of several.
  struct Letters {
    std::string_view all, single, several;
  };
  /// A multiplier and its condition; a leaf has no condition twice.
  Multiple multiple(std::set<std::string_view> &conditions, const Letters &of, unsigned version) {
    const mpz_class m = integer();
    const std::string_view name = word(), j = name.substr(std::min<std::size_t>(1, name.size()));
    const ClassRange range = j.empty() ? ClassRange{0, 0} : classes(j, version);
    const std::string_view letters = j.empty() ? of.all : range.i < range.j ? of.several : of.single;
    demand_form(
        !name.empty() && letters.find(name[0]) != std::string_view::npos && (j.empty() || range.i > 0), line_,
        "is no condition: write a letter of the format, and its classes where it has any", name);
    demand_form(conditions.insert(name).second, line_, "is twice in a leaf: add its multipliers", name);
    return {m, name[0], range};
  }
  /// The number of the witness and the bound: `N`, or with version 2 `B..N` and `B..`.
  void read_particles(Certificate &c) {
    demand("particles");
    const std::string_view text = word();
    const std::size_t dots = text.find("..");
    const bool single = dots == std::string_view::npos;
    check(c.version >= 2 || single, "bounds need `mdm-certificate 2`: let mdm solve --proof write it again");
    const std::string_view most = single ? text : text.substr(dots + 2);
    if (!most.empty())
      c.particles.push_back(number('1', most));
    c.bound.push_back(number(c.particles.empty() ? '2' : '1', text.substr(0, dots)));
    check(single || c.particles.empty() || c.bound[0].value < c.particles[0].value,
          "bounds that do not ascend: write one number where they are the same");
    end();
  }

private:
  ClassRange classes(std::string_view text, unsigned version) const {
    const std::size_t dash = text.find('-');
    const std::uint64_t i = index(text.substr(0, dash));
    if (dash == std::string_view::npos)
      return {i, i};
    check(version >= 2, "sums of classes need `mdm-certificate 2`: let mdm solve --proof write it again");
    const std::uint64_t j = index(text.substr(dash + 1));
    demand_form(i < j, line_, "are no classes i-j with i < j: write a single class once", text);
    return {i, j};
  }
};

void read_question(Lines &lines, Certificate &c) {
  c.version = lines.take("mdm-certificate 3") ? 3 : lines.take("mdm-certificate 2") ? 2 : 1;
  if (c.version == 1)
    lines.demand("mdm-certificate 1");
  lines.end();
  read_law_and_openings(lines, c);
  lines.read_if_there("min-per-class", "1", c.min_per_class);
  lines.read_if_there("cylinder", "ddz", c.cylinder);
  lines.read_if_there("box", "dddz", c.box);
  lines.read_if_there("solids-volume", "d", c.solids_volume);
  const auto absent = c.cylinder.empty() + c.box.empty() + c.solids_volume.empty();
  lines.check_before(absent == 3 || (absent == 2 && c.law[0].value == 3),
                     "solids need `law 3` and one line alone: drop the others");
  lines.read_if_there("pi", "dd", c.pi);
  lines.check_before(c.pi.empty() == (c.box.empty() && c.solids_volume.empty()),
                     "`pi` belongs to `box` and `solids-volume`: give both");
  if (!c.pi.empty())
    lines.check_before(c.pi[0].value >= 3 && c.pi[0].value < c.pi[1].value && c.pi[1].value <= 4 &&
                           std::max(c.pi[0].text.size(), c.pi[1].text.size()) <= 1002,
                       "bounds of pi must be 3 <= p < r <= 4 with at most 1000 digits after the point");
  lines.read_if_there("at-least", "2", c.at_least);
}

void read_classes(Lines &lines, std::vector<ClassWitness> &classes, bool with_masses) {
  while (lines.take("class")) {
    const ClassWitness witness{lines.index(), lines.integer(),
                               with_masses ? lines.number('R').value : mpq_class(0), lines.number('D').value,
                               lines.number('D').value};
    lines.check(witness.lo <= witness.hi && (classes.empty() || classes.back().index < witness.index),
                "classes that do not ascend, or bounds of a size that do not: sort them");
    lines.check(classes.size() < most_classes,
                "more classes than a gradation can have: drop those that are not there");
    classes.push_back(witness);
    lines.end();
  }
}

TreeNode read_split(Lines &lines, unsigned version) {
  TreeNode node;
  if (version == 3 && lines.take("split M")) {
    node.kind = TreeNode::split_of_mass;
    node.v = lines.number('R').value;
  } else {
    lines.demand("split");
    node.kind = TreeNode::split;
    node.classes = lines.classes(version);
    node.v = lines.integer();
  }
  return node;
}

/// Reads nodes until every split has its two subtrees.
void read_tree(Lines &lines, std::vector<TreeNode> &tree, unsigned version) {
  constexpr Lines::Letters of_leaf{"EmwnN", "fFqQrRpPex", "sSd"}, of_window{"tTEwnN", "pP", "sS"};
  std::uint64_t size = 0;
  const auto grow = [&](std::uint64_t terms) {
    lines.check((size += terms) <= most_of_tree,
                "more than 4194304 nodes and multiples: search for a smaller tree");
  };
  for (std::size_t open = 1; open > 0; grow(1)) {
    TreeNode node;
    if (lines.begins_with("split")) {
      node = read_split(lines, version);
      ++open;
    } else {
      const bool is_window = version == 3 && lines.take("window");
      if (is_window)
        node.kind = TreeNode::window;
      else
        lines.demand("leaf");
      std::set<std::string_view> conditions;
      for (--open; (!is_window && node.multiples.empty()) || lines.more();
           grow(node.multiples.back().terms()))
        node.multiples.push_back(lines.multiple(conditions, is_window ? of_window : of_leaf, version));
    }
    tree.push_back(std::move(node));
    lines.end();
  }
}

} // namespace

Certificate read_certificate(std::string_view text) {
  Lines lines(text);
  Certificate c{};
  read_question(lines, c);
  const bool tolerant = read_tolerance(lines, c);
  lines.check(tolerant || c.min_per_class.empty() || c.min_per_class[0].value >= 2,
              "min-per-class 1 says nothing of an exact match: leave it out");
  if (tolerant && lines.take("particles none")) {
    lines.end();
  } else {
    lines.read_particles(c);
    if (!tolerant) {
      lines.check_before(!c.particles.empty(), "an exact match is there: write its bounds as B..N");
      lines.check_before(c.version == (c.bound[0].value < c.particles[0].value ? 2 : 1),
                         "`mdm-certificate 2` needs bounds or a tolerance: write 1 without them");
      lines.read("scale", "r", c.scale);
    }
    if (!c.particles.empty())
      read_classes(lines, c.classes, tolerant);
  }
  if (tolerant) {
    read_tree(lines, c.tree, c.version);
  } else if (c.at_least.empty() || c.at_least[0].value != c.bound[0].value) {
    if (!c.at_least.empty())
      lines.read_if_there("above", "r", c.above);
    lines.demand("chain");
    for (c.chain.emplace(); lines.more();)
      c.chain->push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(lines.index(), 0xFFFF'FFFF)));
    lines.end();
  }
  lines.demand("end");
  lines.end_file();
  c.longest_count = lines.longest_count();
  return c;
}

} // namespace mdm::checker
