#include "layers/wall_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <string_view>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "curve/named_curves.hpp"
#include "layers/layer_rules.hpp"
#include "sizing/boundary_sizes.hpp"

namespace quadrille::layers {
namespace {

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  WallSpec parse(double yplus) {
    const std::size_t colon = text_.rfind(':');
    if (colon == std::string::npos || colon == 0) fail("expected NAME:first=H,layers=N");
    spec_.names = split_at_commas(std::string_view(text_).substr(0, colon));
    for (const std::string& pair : split_at_commas(std::string_view(text_).substr(colon + 1))) {
      const std::size_t equals = pair.find('=');
      if (equals == std::string::npos) fail(fmt::format("'{}' is not key=value", pair));
      const std::string key = pair.substr(0, equals);
      if (!seen_.insert(key).second) fail(fmt::format("{} is given twice", key));
      set(key, pair.substr(equals + 1));
    }
    if (!seen_.contains("first") && !seen_.contains("yplus")) spec_.yplus = yplus;
    require_complete();
    return spec_;
  }

 private:
  void set(const std::string& key, const std::string& value) {
    if (key == "first")
      spec_.first = number(key, value, 0, 1e300);
    else if (key == "yplus")
      spec_.yplus = number(key, value, 0, 1e300);
    else if (key == "thickness")
      spec_.thickness = number(key, value, 0, 1e300);
    else if (key == "growth")
      spec_.growth = number(key, value, 1, 2);
    else if (key == "layers")
      set_layers(value);
    else if (key == "law")
      set_law(value);
    else if (key == "blocks")
      set_blocks(value);
    else
      fail(fmt::format("unknown key '{}': expected first, yplus, growth, layers, thickness, law or blocks", key));
  }

  void set_layers(const std::string& value) {
    spec_.as_many_as_fit = value == "fit";
    if (spec_.as_many_as_fit) return;
    const double layers = number("layers", value, 1, layer_constants.max_layers);
    spec_.layers = static_cast<int>(layers);
    if (spec_.layers != layers) fail("layers must be a whole number or 'fit'");
  }

  void set_law(const std::string& value) {
    if (value == "uniform")
      spec_.law = LayerLaw::uniform;
    else if (value == "geometric")
      spec_.law = LayerLaw::geometric;
    else if (value == "tanh")
      spec_.law = LayerLaw::tanh;
    else if (value == "gll")
      spec_.law = LayerLaw::gll;
    else
      fail(fmt::format("unknown law '{}': expected uniform, geometric, tanh or gll", value));
  }

  void set_blocks(const std::string& value) {
    if (value != "own" && value != "shared") fail(fmt::format("blocks={}: expected own or shared", value));
    spec_.own_blocks = value == "own";
  }

  double number(const std::string& key, const std::string& value, double low, double high) const {
    double result = 0;
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
    if (error != std::errc() || end != value.data() + value.size())
      fail(fmt::format("{}: '{}' is not a number", key, value));
    if (!(result >= low && result <= high)) fail(fmt::format("{} must lie in {:g}..{:g}", key, low, high));
    return result;
  }

  void require_complete() const {
    if (seen_.contains("first") && seen_.contains("yplus")) fail("one of first and yplus must be given, not both");
    if (!(spec_.first > 0 || spec_.yplus > 0))
      fail("first, the height of the first layer, or yplus must be given and positive");
    if (seen_.count("layers") + seen_.count("thickness") != 1) fail("one of layers and thickness must be given");
    if (seen_.count("thickness") && !(spec_.thickness > 0)) fail("thickness must be positive");
    if (spec_.own_blocks && spec_.as_many_as_fit) fail("blocks=own needs a number of layers, or thickness");
  }

  [[noreturn]] void fail(const std::string& why) const { throw UsageError(fmt::format("--wall {}: {}", text_, why)); }

  const std::string& text_;
  WallSpec spec_;
  std::set<std::string> seen_;
};

}  // namespace

WallSpec parse_wall_spec(const std::string& text, double yplus) { return Parser(text).parse(yplus); }

void set_first_heights(std::vector<WallSpec>& specs, const prescribe::PlateFlow& flow, double unit) {
  for (WallSpec& spec : specs)
    if (spec.yplus > 0) spec.first = flow.height(spec.yplus) * unit;
}

std::vector<int> curve_walls(const std::vector<WallSpec>& specs, const CadFace& face) {
  std::vector<int> walls(face.curves.size(), -1);
  for (std::size_t i = 0; i < specs.size(); ++i)
    for (const std::string& name : specs[i].names)
      for (const int curve : curve::named_curves(face, name, "--wall")) {
        if (walls[curve] >= 0)
          throw UsageError(
              fmt::format("--wall: the boundary '{}' is named twice: a boundary has one set of layers", name));
        walls[curve] = static_cast<int>(i);
      }
  return walls;
}

}  // namespace quadrille::layers
