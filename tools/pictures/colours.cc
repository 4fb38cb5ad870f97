// SPDX-License-Identifier: BSD-3-Clause
#include "pictures/colours.hh"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace surfmesh {
namespace {

Rgb from_hex(unsigned value) {
  return {(value >> 16 & 255U) / 255.0, (value >> 8 & 255U) / 255.0, (value & 255U) / 255.0};
}

/// Viridis (Smith and van der Walt 2015, CC0), from where it is no longer black in print.
const std::array kAmounts = {from_hex(0x472d7b), from_hex(0x3b528b), from_hex(0x2c728e),
                             from_hex(0x21918c), from_hex(0x28ae80), from_hex(0x5ec962),
                             from_hex(0xaddc30), from_hex(0xfde725)};

/// From ColorBrewer's RdYlGn and RdBu (Apache 2.0), the latter with grey in the middle, which shows
/// on white paper.
const std::array kGoodness = {from_hex(0xa50026), from_hex(0xd73027), from_hex(0xf46d43),
                              from_hex(0xfdae61), from_hex(0xfee08b), from_hex(0xd9ef8b),
                              from_hex(0xa6d96a), from_hex(0x66bd63), from_hex(0x1a9850)};
const std::array kDeviations = {from_hex(0x2166ac), from_hex(0x4393c3), from_hex(0x92c5de),
                                from_hex(0xdddddd), from_hex(0xf4a582), from_hex(0xd6604d),
                                from_hex(0xb2182b)};

/// Hues of neighbouring indices are a golden share of a turn apart.
constexpr double kGoldenShare = 0.618033988749895;

/// One channel of a colour of full saturation, by its hue in turns.
double channel(double hue) {
  const double turn = 6 * (hue - std::floor(hue));
  return std::clamp(std::abs(turn - 3) - 1, 0.0, 1.0);
}

/// Sizes that are smaller by more than this ratio than the greatest have one colour.
constexpr double kGreatestSizeRatio = 1e4;

/// Sizes between which the ratio is less have nearly one colour.
constexpr double kLeastSizeRatio = 1.01;

template <class Chosen>
std::pair<double, double> extremes(const std::vector<double>& values, Chosen is_chosen) {
  double least = INFINITY, greatest = -INFINITY;
  for (const double value : values) {
    if (!is_chosen(value)) continue;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  return least <= greatest ? std::pair(least, greatest) : std::pair(0.0, 1.0);
}

}  // namespace

std::string hex(const Rgb& colour) {
  const auto byte = [](double part) { return std::lround(255 * std::clamp(part, 0.0, 1.0)); };
  return fmt::format("#{:02x}{:02x}{:02x}", byte(colour.red), byte(colour.green),
                     byte(colour.blue));
}

std::span<const Rgb> stops(ColourMap map) {
  switch (map) {
    case ColourMap::Goodness:
      return kGoodness;
    case ColourMap::Deviations:
      return kDeviations;
    case ColourMap::Amounts:
      break;
  }
  return kAmounts;
}

Rgb colour_at(ColourMap map, double share) {
  const std::span<const Rgb> colours = stops(map);
  if (std::isnan(share)) return kNoValueColour;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const double t = place - static_cast<double>(i);
  const Rgb &a = colours[i], &b = colours[i + 1];
  return {a.red + t * (b.red - a.red), a.green + t * (b.green - a.green),
          a.blue + t * (b.blue - a.blue)};
}

Rgb category_colour(std::size_t index) {
  const double hue = 0.58 + kGoldenShare * static_cast<double>(index);
  const double saturation = index % 2 == 0 ? 0.45 : 0.6, brightness = index % 3 == 0 ? 0.92 : 0.82;
  const auto part = [&](double shift) {
    return brightness * (1 - saturation + saturation * channel(hue + shift));
  };
  return {part(0), part(2.0 / 3), part(1.0 / 3)};
}

double ColourScale::share(double value) const {
  const auto place = [&](double x) { return is_log ? std::log(x) : x; };
  if (!(to > from)) return 0.5;
  return std::clamp((place(value) - place(from)) / (place(to) - place(from)), 0.0, 1.0);
}

ColourScale scale_of(MeshField field, const std::vector<double>& values, bool is_of_quads) {
  const auto finite = [](double value) { return std::isfinite(value); };
  const auto positive = [](double value) { return std::isfinite(value) && value > 0; };
  switch (field) {
    case MeshField::Quality:
    case MeshField::Shape:
      return {ColourMap::Goodness, 0, 1, false};
    case MeshField::Length:
      return {ColourMap::Deviations, 0.5, 2, true};
    case MeshField::Valence:
      return {ColourMap::Deviations, is_of_quads ? 1.0 : 3.0, is_of_quads ? 7.0 : 9.0, false};
    case MeshField::Size:
    case MeshField::Stretch: {
      const auto [least, greatest] = extremes(values, positive);
      if (greatest < kLeastSizeRatio * least) {  // rounding is not to be seen
        return {ColourMap::Amounts, least / kLeastSizeRatio, greatest * kLeastSizeRatio, true};
      }
      return {ColourMap::Amounts, std::max(least, greatest / kGreatestSizeRatio), greatest, true};
    }
    case MeshField::Sag:
      return {ColourMap::Amounts, 0, extremes(values, finite).second, false};
    case MeshField::Patch:
    case MeshField::Group:
      break;
  }
  const auto [least, greatest] = extremes(values, finite);
  return {ColourMap::Amounts, least, greatest, false};
}

}  // namespace surfmesh
