// The progress of a search goes to JavaScript, which has no terminal and ends a search with its worker.
#include "cli/search_progress.hpp"

#include <mdm/number/integer.hpp>

#include <emscripten.h>

#include <utility>

namespace mdm::cli {
namespace {

/// Calls Module.onProgress, if there is one, ten times a second at most. `most` is empty without a match.
EM_JS(void, tell_bounds, (const char *least, const char *most), {
  const now = Date.now();
  if (!Module['onProgress'] || now - (Module['lastProgress'] || 0) < 100)
    return;
  Module['lastProgress'] = now;
  Module['onProgress'](UTF8ToString(least), UTF8ToString(most));
});

} // namespace

SearchProgress::SearchProgress(bool quiet) : line_([this] { return text(); }, quiet) {}

ProgressCall SearchProgress::call() {
  return [](const mdm::Progress &progress) {
    const std::string most = progress.particles ? to_string(*progress.particles) : "";
    tell_bounds(to_string(progress.lower_bound).c_str(), most.c_str());
    return true;
  };
}

std::string SearchProgress::text() {
  return "";
}

} // namespace mdm::cli
