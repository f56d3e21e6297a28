#include "draw/svg.hpp"

#include <fmt/format.h>

namespace quadrille::draw {

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  return out;
}

std::string svg_number(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

void PathData::add(char command, std::initializer_list<Vec2> points) {
  d_ += command;
  bool first = true;
  for (const Vec2 p : points)
    for (const double value : {p.x, p.y}) {
      const std::string number = svg_number(value, digits_);
      if (!first && number[0] != '-') d_ += ' ';
      d_ += number;
      first = false;
    }
}

void PathData::move_to(Vec2 p) { add('M', {p}); }
void PathData::line_to(Vec2 p) { add('L', {p}); }
void PathData::cubic_to(Vec2 c1, Vec2 c2, Vec2 p) { add('C', {c1, c2, p}); }

std::string svg_element(const std::string& name, const Attributes& attributes, const std::string& title,
                        const std::string& inner) {
  std::string out = '<' + name;
  for (const auto& [key, value] : attributes) out += ' ' + key + "=\"" + xml_escaped(value) + '"';
  if (title.empty() && inner.empty()) return out + "/>";
  out += '>';
  if (!title.empty()) out += "<title>" + xml_escaped(title) + "</title>";
  return out + inner + "</" + name + '>';
}

}  // namespace quadrille::draw
