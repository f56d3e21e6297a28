// The colours of lib/show/draw/palette.hpp for the page's script.
#include "page/page_data.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "base/json_string.hpp"
#include "draw/palette.hpp"

namespace quadrille::page {

namespace {

template <typename T>
std::string packed_bytes(const std::vector<T>& values) {
  std::string bytes;
  bytes.reserve(values.size() * sizeof(T));
  for (const T value : values) {
    const auto bits = static_cast<std::uint32_t>(value);
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(bits >> (8 * i) & 255);
  }
  return base64(bytes);
}

/// Replaces the three characters that end or open markup by what `escape` gives.
template <typename Escape>
std::string without_markup(const std::string& text, const Escape& escape) {
  std::string out;
  for (const char c : text)
    if (c == '<' || c == '>' || c == '&')
      out += escape(c);
    else
      out += c;
  return out;
}

/// [[position, colour], ...].
std::string ramp_json(const draw::Ramp& ramp) {
  std::vector<std::string> stops;
  for (const draw::ColourStop& stop : ramp)
    stops.push_back(json_list({fmt::format("{:.4g}", stop.position), script_string(stop.colour)}));
  return json_list(stops);
}

std::string palette_json(draw::Paper paper) {
  const draw::Palette& colours = draw::palette(paper);
  JsonObject object;
  object.json("quality", ramp_json(colours.quality)).json("amount", ramp_json(colours.amount));
  object.json("angle", ramp_json(draw::cross_angle_ramp(paper)));
  object.text("calm", draw::cross_angle_colour(paper, 0, 0));
  object.json("blocks", json_texts(colours.blocks)).json("lines", json_texts(colours.lines));
  object.json("contours", json_texts({colours.u_contour, colours.v_contour}));
  object.text("interface", colours.interface);
  return object.text("few", colours.few).text("many", colours.many).text("other", colours.other).str();
}

}  // namespace

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string packed(const std::vector<std::int32_t>& values) { return packed_bytes(values); }
std::string packed(const std::vector<std::int16_t>& values) { return packed_bytes(values); }
std::string packed(const std::vector<std::uint8_t>& values) { return packed_bytes(values); }

std::string packed_floats(const std::vector<double>& values) {
  std::vector<std::int32_t> bits;
  bits.reserve(values.size());
  for (const double value : values) bits.push_back(std::bit_cast<std::int32_t>(static_cast<float>(value)));
  return packed_bytes(bits);
}

std::string script_json(const std::string& json) {
  return without_markup(json, [](char c) { return fmt::format("\\u{:04x}", static_cast<int>(c)); });
}

std::string script_string(const std::string& text) { return script_json(json_string(text)); }

std::string html_text(const std::string& text) {
  std::string out;
  for (const char c : without_markup(text, [](char c) { return c == '<' ? "&lt;" : c == '>' ? "&gt;" : "&amp;"; }))
    if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return out;
}

std::string json_list(const std::vector<std::string>& values) { return fmt::format("[{}]", fmt::join(values, ",")); }

std::string json_texts(const std::vector<std::string>& texts) {
  std::vector<std::string> values;
  values.reserve(texts.size());
  for (const std::string& text : texts) values.push_back(script_string(text));
  return json_list(values);
}

JsonObject& JsonObject::json(const std::string& key, const std::string& value) {
  members_ += fmt::format("{}\"{}\":{}", members_.empty() ? "" : ",", key, value);
  return *this;
}

JsonObject& JsonObject::number(const std::string& key, double value) {
  return json(key, std::isfinite(value) ? fmt::format("{:.17g}", value) : "null");
}

std::string palettes_json() {
  JsonObject object;
  object.json("light", palette_json(draw::Paper::light));
  return object.json("dark", palette_json(draw::Paper::dark)).str();
}

}  // namespace quadrille::page
