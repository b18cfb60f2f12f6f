#include "cli/verification_output.hpp"

#include "files/standard_streams.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {

void write_verification(const Verification &v, const OutputFlags &flags, Output &out) {
  out.write(flags.report([&] { return verification_text(v); }, [&] { return verification_json(v); },
                         [&] { return verification_csv(v); }));
  if (flags.is_csv() && v.verdict() != Verdict::match)
    tell(printable(v.sample) + ": " + headline(v) + "\n");
  flags.tell_notes_beside_csv(v.notes);
}

} // namespace mdm::cli
