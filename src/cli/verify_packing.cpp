#include "cli/verify_packing.hpp"

#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "report/packing_report.hpp"

#include <mdm/packing/packing_reader.hpp>
#include <mdm/packing/packing_verdict.hpp>
#include <mdm/text/error.hpp>

#include <fstream>

namespace mdm::cli {
namespace {

/// A line of a packing has some sixty characters.
constexpr std::size_t most_bytes = std::size_t{1} << 30;

} // namespace

bool is_file_of_disc_sizes(const std::string &path) {
  constexpr std::size_t looked_at = 256;
  std::string begin(looked_at, ' ');
  std::ifstream file(path, std::ios::binary);
  file.read(begin.data(), looked_at);
  begin.resize(static_cast<std::size_t>(file.gcount()));
  return has_disc_sizes(begin);
}

int verify_packing(const std::string &sizes, const std::string &packing, const std::string &out) {
  const DiscSizes wanted = read_disc_sizes(read_file(sizes, most_bytes), shown_name(sizes));
  const Packing p = read_packing(read_file(packing, most_bytes), shown_name(packing));
  const PackingTexture texture = packing_texture(p);
  const std::vector<std::string> objections = packing_objections(p, texture.contacts, wanted);
  const std::string name = printable(shown_name(packing));
  std::string text = objections.empty() ? name + ": accepted: a packing of the set's discs\n" : "";
  for (const std::string &objection : objections)
    text += name + ": refused: " + objection + "\n";
  Output file(out);
  file.write(text + "\n" + packing_text(p, texture));
  file.commit();
  return objections.empty() ? Exit::done : Exit::negative;
}

} // namespace mdm::cli
