#include "particles/lammps_units.hpp"
#include "particles/line_reader.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace mdm {
namespace {

/// A script of LIGGGHTS, of which only four kinds of lines count: `units STYLE`, `fix ID group
/// particletemplate/sphere ... radius constant R`, `fix ID group particledistribution/discrete/numberbased
/// seed n ID weight ...` where one weight alone is not 0, and `fix ID group insert/pack ...
/// distributiontemplate ID ... region ID particles_in_region N`, N being all particles that are there then.
/// What may bring other particles than these is refused.
class InsertionReader : public LineReader {
public:
  explicit InsertionReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, SizeUnit::m);
  }

  void line(std::string_view text) override {
    split_words(text, words_);
    if (words_.empty() || words_[0].front() == '#')
      return;
    check_line();
    if (words_.size() >= 2 && words_[0] == "units")
      take_units(words_[1], source_);
    constexpr std::size_t style = 3;
    if (words_.size() <= style || words_[0] != "fix")
      return;
    if (words_[style].starts_with("particletemplate/"))
      read_template();
    else if (words_[style].starts_with("particledistribution/"))
      read_distribution();
    else if (words_[style].starts_with("insert/"))
      read_insertion();
  }

  void end() override { source_.check_some(); }

private:
  void check_line() const {
    if (words_.back() == "&")
      source_.refuse("the line goes on in the next one: write it in one line, without &");
    constexpr std::string_view others[] = {"create_atoms", "delete_atoms", "include", "jump",
                                           "read_data",    "read_dump",    "set",     "read_restart"};
    if (std::find(std::begin(others), std::end(others), words_[0]) != std::end(others))
      source_.refuse(
          fmt::format("what {} brings is not known: give a dump of the particles, or the script of "
                      "the insertions alone",
                      in_quotes(words_[0])));
    const auto then = std::find(words_.begin(), words_.end(), "then");
    const bool stops_alone = words_.back() == "quit" && then != words_.end() && then + 1 != words_.end() &&
                             *(then + 1) == "\"print";
    if (words_[0] == "if" && !stops_alone)
      source_.refuse("what an if does is not known, unless it prints and quits: write its lines without it");
  }

  /// The word behind a keyword; empty if it is not there.
  std::string_view behind(std::string_view keyword) const {
    const auto found = std::find(words_.begin(), words_.end(), keyword);
    return found == words_.end() || found + 1 == words_.end() ? std::string_view() : *(found + 1);
  }

  void read_template() {
    const auto found = std::find(words_.begin(), words_.end(), "radius");
    if (words_.end() - found < 3 || *(found + 1) != "constant")
      source_.refuse("the template has no constant radius: write 'radius constant R'");
    radii_[std::string(words_[1])] = *(found + 2);
  }

  void read_distribution() {
    constexpr std::size_t first = 6; // behind the seed and the number of templates
    if (words_[3] != "particledistribution/discrete/numberbased" || words_.size() < first + 2)
      source_.refuse("the distribution is not numberbased with a template: counts cannot be told");
    const std::optional<std::uint64_t> templates = parse_count(words_[first - 1]);
    if (!templates || words_.size() != first + 2 * *templates)
      source_.refuse(
          fmt::format("the distribution has {} templates by its number, and not as many names with "
                      "weights: put one of them right",
                      in_quotes(words_[first - 1])));
    std::string_view only;
    for (std::size_t i = first; i + 1 < words_.size(); i += 2) {
      if (!is_number(words_[i + 1]))
        source_.refuse(fmt::format("the weight {} is not a number", in_quotes(words_[i + 1])));
      if (words_[i + 1].find_first_of("123456789") == std::string_view::npos)
        continue;
      if (!only.empty())
        source_.refuse("the distribution has several templates: LIGGGHTS draws them at random");
      only = words_[i];
    }
    if (only.empty() || radii_.count(std::string(only)) == 0)
      source_.refuse("the distribution has no template that is written above: is the file damaged?");
    distributions_[std::string(words_[1])] = radii_[std::string(only)];
  }

  void read_insertion() {
    const auto radius = distributions_.find(std::string(behind("distributiontemplate")));
    if (radius == distributions_.end())
      source_.refuse("the insertion has no distributiontemplate that is written above: is the file damaged?");
    const std::string_view count = behind("particles_in_region");
    const std::optional<std::uint64_t> total = parse_count(count);
    if (!total || *total <= total_)
      source_.refuse(fmt::format("particles_in_region {} is no number above {}, the total so far: give the "
                                 "running total",
                                 in_quotes(count), total_));
    const std::string_view region = behind("region");
    if (total_ > 0 && region != region_)
      source_.refuse(fmt::format("the region is {}, and {} above: give the insertions of one region",
                                 in_quotes(region), in_quotes(region_)));
    region_ = region;
    source_.particle(radius->second, Integer(*total - total_));
    total_ = *total;
  }

  ParticleSource &source_;
  std::vector<std::string_view> words_;
  std::map<std::string, std::string> radii_;         ///< of templates
  std::map<std::string, std::string> distributions_; ///< the radius of each
  std::string region_;
  std::uint64_t total_ = 0;
};

} // namespace

std::unique_ptr<LineReader> read_liggghts_insertion(ParticleSource &source) {
  return std::make_unique<InsertionReader>(source);
}

} // namespace mdm
