#include "draw/embedded.hpp"

#include <fmt/format.h>

#include "draw/svg.hpp"

namespace quadrille::draw {

std::string embedded(const std::string& svg, const std::string& prefix, double x) {
  std::string part = svg.substr(svg.find("<svg "));
  part.insert(5, fmt::format("x=\"{}\" ", svg_number(x)));
  for (const std::string& mark : {std::string(" id=\""), std::string("\"url(#")})
    for (std::size_t at = part.find(mark); at != std::string::npos; at = part.find(mark, at + 1))
      part.insert(at + mark.size(), prefix);
  return part;
}

double height_of(const std::string& svg) { return std::stod(svg.substr(svg.find("height=\"") + 8)); }

std::string begin_parts(const std::string& title, int width, double height) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" viewBox=\"0 0 {0} {1:.0f}\">\n"
      "<title>{2}</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height, xml_escaped(title));
}

}  // namespace quadrille::draw
