#include "plot/svg_canvas.hpp"

#include "text/xml_text.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <optional>

namespace mdm {
namespace {

/// pt with two places, and no more than it needs.
std::string pt(double value) {
  std::string text = fmt::format("{:.2f}", value);
  while (text.back() == '0')
    text.pop_back();
  if (text.back() == '.')
    text.pop_back();
  return text == "-0" ? "0" : text;
}

class SvgCanvas : public Canvas {
public:
  SvgCanvas(double width, double height, std::string_view title, std::string_view description) {
    add("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\" font-family=\"sans-serif\" font-size=\"{2}\" stroke-linejoin=\"round\">\n",
        pt(width), pt(height), pt(letter_size));
    if (!title.empty())
      add("<title>{}</title>\n", xml_text(title));
    if (!description.empty())
      add("<desc>{}</desc>\n", xml_text(description));
    add("<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n", pt(width), pt(height));
  }

  void clip(const Frame &frame) override {
    end_group();
    ++clips_;
    add("<clipPath id=\"clip{0}\"><rect x=\"{1}\" y=\"{2}\" width=\"{3}\" height=\"{4}\"/></clipPath>\n"
        "<g clip-path=\"url(#clip{0})\">\n",
        clips_, pt(frame.left), pt(frame.top), pt(frame.right - frame.left), pt(frame.bottom - frame.top));
  }

  void unclip() override {
    end_group();
    add("</g>\n");
  }

  void lines(const std::vector<std::vector<Place>> &pieces, bool closed, const Look &look) override {
    begin_group(look);
    add("<path d=\"");
    for (const std::vector<Place> &piece : pieces) {
      char command = 'M';
      for (const Place &p : piece) {
        add("{}{} {}", command, pt(p.x), pt(p.y));
        command = 'L';
      }
      if (closed && !piece.empty())
        add("Z");
    }
    add("\"/>\n");
  }

  void circle(Place center, double radius, const Look &look) override {
    begin_group(look);
    add("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", pt(center.x), pt(center.y), pt(radius));
  }

  void text(Place at, std::string_view text, const TextLook &look) override {
    end_group();
    static constexpr std::array<const char *, 3> anchors = {"", " text-anchor=\"middle\"",
                                                            " text-anchor=\"end\""};
    const double x = at.x + (look.upright ? middle_of_letters * look.size : 0);
    const double y = at.y + (look.upright ? 0 : middle_of_letters * look.size);
    add("<text x=\"{}\" y=\"{}\"{}", pt(x), pt(y), anchors.at(static_cast<std::size_t>(look.align)));
    if (look.size != letter_size)
      add(" font-size=\"{}\"", pt(look.size));
    if (look.upright)
      add(" transform=\"rotate(-90 {} {})\"", pt(x), pt(y));
    add(">{}</text>\n", xml_text(text));
  }

  std::string finish() override {
    end_group();
    add("</svg>\n");
    return fmt::to_string(text_);
  }

private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  /// Shapes of one look that follow each other share its attributes.
  void begin_group(const Look &look) {
    if (group_ == look)
      return;
    end_group();
    static constexpr std::array<const char *, 4> dashes = {"", "", " stroke-dasharray=\"9 5\"",
                                                           " stroke-dasharray=\"2 3\""};
    add("<g fill=\"{}\"", look.fill.empty() ? "none" : look.fill);
    if (!look.line.empty())
      add(" stroke=\"{}\" stroke-width=\"{}\"{}", look.line, pt(look.width),
          dashes.at(static_cast<std::size_t>(look.stroke)));
    add(">\n");
    group_ = look;
  }

  void end_group() {
    if (group_)
      add("</g>\n");
    group_.reset();
  }

  fmt::memory_buffer text_;
  std::optional<Look> group_;
  unsigned clips_ = 0;
};

} // namespace

std::unique_ptr<Canvas> svg_canvas(double width, double height, std::string_view title,
                                   std::string_view description) {
  return std::make_unique<SvgCanvas>(width, height, title, description);
}

} // namespace mdm
