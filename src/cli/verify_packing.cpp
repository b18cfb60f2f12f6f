#include "cli/verify_packing.hpp"

#include "cli/commands.hpp"
#include "files/output.hpp"
#include "files/packing_file.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "packing/packing_verdict.hpp"
#include "report/packing_report.hpp"

namespace mdm::cli {

int verify_packing(const std::string &sizes, const std::string &packing, const OutputFlags &output) {
  const DiscSizes wanted = read_disc_sizes_file(sizes);
  const Packing p = read_packing_file(packing);
  const PackingTexture texture = packing_texture(p);
  const PackingJudgement judgement{shown_name(sizes), shown_name(packing),
                                   packing_objections(p, texture.contacts, wanted), unverified(p)};
  Output file(output.path());
  const Sink sink = [&file](std::string_view text) { file.write(text); };
  if (output.is_json()) {
    packing_json(p, texture, {false, &judgement}, sink);
    sink("\n");
  } else if (output.is_csv()) {
    sink(packing_csv(p, texture));
    // CSV has no place for a verdict.
    if (!judgement.is_accepted())
      tell(packing_judgement_text(judgement));
  } else {
    sink(packing_judgement_text(judgement) + "\n" + packing_text(p, texture));
  }
  file.commit();
  return judgement.is_accepted() ? Exit::done : Exit::negative;
}

} // namespace mdm::cli
