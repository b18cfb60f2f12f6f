#include "report/reading_report.hpp"

#include "answer/json_values.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

std::string reading_text(const UnderstoodGradation &u, const std::string &file) {
  const Gradation &g = u.gradation;
  std::string text = file + ": " + u.format + "\n";
  text += "  id      " + printable(g.id()) + "\n";
  text += "  sizes   " + u.sizes + "\n";
  text += "  masses  " + u.masses + "\n";
  text += std::string("  pan     ") + (g.has_pan() ? "yes, at size 0" : "none") + "\n";
  text += std::string("  check   ") +
          (u.is_canonical ? "mdm-check reads the file as it is" : "mdm-check reads what mdm convert writes") +
          "\n";
  for (const std::string &sample : u.samples)
    text += "  sample  " + printable(sample) + "\n";
  for (const std::string &note : g.notes())
    text += "  note    " + note + "\n";
  return text;
}

std::string reading_json(const UnderstoodGradation &u) {
  const Gradation &g = u.gradation;
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-reading-1").key("id").string(g.id());
  json.key("format").string(u.format).key("sizes").string(u.sizes).key("masses").string(u.masses);
  json.key("unit").plain(name(g.unit())).key("kind").plain(u.kind);
  json.key("classes").number(g.classes()).key("pan").boolean(g.has_pan());
  json.key("canonical").boolean(u.is_canonical).key("samples").strings(u.samples);
  json.key("notes").strings(g.notes()).key("versions").raw(versions_json()).end_object();
  return json.take();
}

} // namespace mdm
