// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/set_option.hh"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "surfmesh/core/error.hh"
#include "surfmesh/core/parallel.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/sizes/length.hh"

namespace surfmesh {
namespace {

constexpr std::size_t kLongestQuote = 40;

/// The text of an option with its name for messages.
class OptionText {
 public:
  OptionText(std::string_view name, std::string_view text) : name_(name), text_(text) {}

  [[noreturn]] void fail_range(std::string_view range) const {
    fail(fmt::format("is outside its range: {}", range));
  }

  bool is(std::string_view word) const { return text_ == word; }

  /// A number for which `is_legal` holds.
  template <class IsLegal>
  double number(std::string_view range, IsLegal is_legal) const {
    double value = 0;
    const auto [stop, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    const bool is_read = error == std::errc() && stop == text_.data() + text_.size();
    if (!is_read || !std::isfinite(value) || !is_legal(value)) fail_range(range);
    return value;
  }

  double number_from(double least, std::string_view range) const {
    return number(range, [least](double x) { return x >= least; });
  }

  /// An integer from `least` to `most`.
  double integer(double least, double most, std::string_view range) const {
    return number(range, [=](double x) { return x >= least && x <= most && x == std::floor(x); });
  }

  Length length() const {
    return length("a length above 0, or a share of the diagonal such as 0.1%");
  }

  Length length(std::string_view range) const {
    try {
      const Length length = parse_length(text_);
      if (length.value > 0) return length;
    } catch (const Error&) {
    }
    fail_range(range);
  }

  bool boolean() const {
    if (!is("true") && !is("false")) fail_range("true or false");
    return is("true");
  }

  /// The index of the value in the list of those that exist.
  std::size_t choice(std::initializer_list<std::string_view> built) const {
    const auto found = std::find(built.begin(), built.end(), text_);
    if (found == built.end()) fail_range(fmt::format("{}", fmt::join(built, " or ")));
    return static_cast<std::size_t>(found - built.begin());
  }

  /// Accept the values that are built; tell those that are planned from those that make no sense.
  void expect(std::initializer_list<std::string_view> built,
              std::initializer_list<std::string_view> planned) const {
    if (std::find(planned.begin(), planned.end(), text_) != planned.end()) fail_not_built(built);
    choice(built);
  }

  /// Accept a number if it is one of `built`.
  void expect_number(std::initializer_list<double> built, std::string_view range) const {
    const double value = number_from(0, range);
    if (std::find(built.begin(), built.end(), value) == built.end()) fail_not_built(built);
  }

  template <class Values>
  [[noreturn]] void fail_not_built(const Values& built) const {
    fail(fmt::format("is not built yet; now there is {}", fmt::join(built, ", ")));
  }

 private:
  [[noreturn]] void fail(std::string_view reason) const {
    throw Error(ErrorCode::InvalidOption,
                fmt::format("{} = {} {}", name_, text_.substr(0, kLongestQuote), reason));
  }

  std::string_view name_;
  std::string_view text_;
};

constexpr double kMostInt = std::numeric_limits<int>::max();
/// Integers up to 2^53 are exact in a double.
constexpr double kMostExactInteger = 9007199254740992;

constexpr std::string_view kPositive = "above 0";
constexpr std::string_view kFromZero = "0 or above";

bool is_positive(double x) { return x > 0; }

struct OptionEntry {
  std::string_view name;
  bool is_sizing;
  void (*set)(PipelineOptions&, const OptionText&);
  OptionValue (*get)(const PipelineOptions&);
};

using Options = PipelineOptions;
using Text = OptionText;

void set_sag(Options& options, const Text& text) {
  if (text.is("off") || text.is("0")) {
    options.sizing.sag.reset();
  } else {
    options.sizing.sag =
        text.length("off, a length above 0, or a share of the diagonal such as 0.1%");
  }
}

OptionValue get_sag(const Options& options) {
  return options.sizing.sag ? to_text(*options.sizing.sag) : "off";
}

void set_grade(Options& options, const Text& text) {
  options.sizing.grade =
      text.number("0 (off), or 1 and above", [](double x) { return x == 0 || x >= 1; });
}

void set_nodes(Options& options, const Text& text) {
  if (text.is("auto")) {
    options.control.regular_nodes = 0;
  } else {
    options.control.regular_nodes =
        static_cast<int>(text.integer(4, kMostInt, "auto, or 4 and above"));
  }
}

OptionValue get_nodes(const Options& options) {
  if (options.control.regular_nodes == 0) return std::string("auto");
  return std::int64_t{options.control.regular_nodes};
}

void set_smoothing(Options& options, const Text& text) {
  if (text.is("best")) {
    options.improve.sweeps = ImproveOptions{}.sweeps;
  } else {
    options.improve.sweeps =
        static_cast<int>(text.integer(0, kMostInt, "best, or a number of sweeps, 0 or above"));
  }
}

constexpr std::array<std::string_view, 3> kPatchKinds = {"auto", "faces", "blocks"};

void set_patches(Options& options, const Text& text) {
  options.patches =
      static_cast<PatchKind>(text.choice({kPatchKinds[0], kPatchKinds[1], kPatchKinds[2]}));
}

OptionValue get_patches(const Options& options) {
  return std::string(kPatchKinds[static_cast<std::size_t>(options.patches)]);
}

void set_threads(Options& options, const Text& text) {
  if (text.is("all")) {
    options.threads = 0;
  } else {
    options.threads = static_cast<int>(
        text.integer(1, kMostThreads, fmt::format("all, or 1 to {}", kMostThreads)));
  }
}

OptionValue get_threads(const Options& options) {
  if (options.threads == 0) return std::string("all");
  return std::int64_t{options.threads};
}

/// All options, those of the sizing first.
constexpr auto kOptions = std::to_array<OptionEntry>({
    {"curvature", true,
     [](Options& o, const Text& t) { o.sizing.curvature = t.number_from(0, kFromZero); },
     [](const Options& o) -> OptionValue { return o.sizing.curvature_factor(); }},
    {"sag", true, set_sag, get_sag},
    {"hmin", true, [](Options& o, const Text& t) { o.sizing.hmin = t.length(); },
     [](const Options& o) -> OptionValue { return to_text(o.sizing.hmin); }},
    {"hmax", true, [](Options& o, const Text& t) { o.sizing.hmax = t.length(); },
     [](const Options& o) -> OptionValue { return to_text(o.sizing.hmax); }},
    {"stretch", true,
     [](Options& o, const Text& t) { o.sizing.stretch = t.number_from(1, "1 or above"); },
     [](const Options& o) -> OptionValue { return o.sizing.stretch; }},
    {"grade", true, set_grade, [](const Options& o) -> OptionValue { return o.sizing.grade; }},
    {"contour_curvature", true,
     [](Options& o, const Text& t) { o.sizing.contour_curvature = t.boolean(); },
     [](const Options& o) -> OptionValue { return o.sizing.contour_curvature; }},
    {"proximity", true,
     [](Options& o, const Text& t) { o.sizing.proximity = t.number_from(0, kFromZero); },
     [](const Options& o) -> OptionValue { return o.sizing.proximity; }},
    {"features", true, [](Options& o, const Text& t) { o.sizing.features = t.boolean(); },
     [](const Options& o) -> OptionValue { return o.sizing.features; }},
    {"curvature_from", true,
     [](Options& o, const Text& t) {
       o.sizing.curvature_from = t.choice({"exact", "differences"}) == 0
                                     ? CurvatureFrom::Exact
                                     : CurvatureFrom::Differences;
     },
     [](const Options& o) -> OptionValue {
       const bool is_exact = o.sizing.curvature_from == CurvatureFrom::Exact;
       return std::string(is_exact ? "exact" : "differences");
     }},
    {"nodes", false, set_nodes, get_nodes},
    {"precision", false,
     [](Options& o, const Text& t) { o.control.precision = t.number(kPositive, is_positive); },
     [](const Options& o) -> OptionValue { return o.control.precision; }},
    {"control", false,
     [](Options& o, const Text& t) {
       o.control.kind = t.choice({"mesh", "grid"}) == 0 ? ControlKind::Mesh : ControlKind::Grid;
     },
     [](const Options& o) -> OptionValue {
       return std::string(o.control.kind == ControlKind::Mesh ? "mesh" : "grid");
     }},
    {"interpolation", false,
     [](Options& o, const Text& t) {
       o.control.interpolation =
           static_cast<Interpolation>(t.choice({"s", "t", "o", "auto", "linear"}));
     },
     [](const Options& o) -> OptionValue {
       constexpr std::array names = {"s", "t", "o", "auto", "linear"};
       return std::string(names[static_cast<std::size_t>(o.control.interpolation)]);
     }},
    {"epsilon", false,
     [](Options& o, const Text& t) { o.control.epsilon = t.number(kPositive, is_positive); },
     [](const Options& o) -> OptionValue { return o.control.epsilon; }},
    {"blend", false,
     [](Options& o, const Text& t) {
       o.control.blend = t.choice({"linear", "log"}) == 0 ? Blend::Linear : Blend::Logarithmic;
     },
     [](const Options& o) -> OptionValue {
       return std::string(o.control.blend == Blend::Linear ? "linear" : "log");
     }},
    {"lookup", false,
     [](Options& o, const Text& t) {
       o.control.lookup =
           t.choice({"disc", "vertices"}) == 0 ? DiscLookup::Disc : DiscLookup::Vertices;
     },
     [](const Options& o) -> OptionValue {
       return std::string(o.control.lookup == DiscLookup::Disc ? "disc" : "vertices");
     }},
    {"inner_nodes", false, [](Options& o, const Text& t) { o.control.inner_nodes = t.boolean(); },
     [](const Options& o) -> OptionValue { return o.control.inner_nodes; }},
    {"reuse", false,
     [](Options& o, const Text& t) { o.control.reuse = t.number_from(0, kFromZero); },
     [](const Options& o) -> OptionValue { return o.control.reuse; }},
    {"placement", false,
     [](Options& o, const Text& t) {
       o.refine.placement = t.choice({"frontal", "circumcentre"}) == 0 ? Placement::Frontal
                                                                       : Placement::Circumcentre;
     },
     [](const Options& o) -> OptionValue {
       return std::string(o.refine.placement == Placement::Frontal ? "frontal" : "circumcentre");
     }},
    {"kernel", false,
     [](Options& o, const Text& t) {
       o.refine.kernel = t.choice({"cavity", "swap"}) == 0 ? Kernel::Cavity : Kernel::Swap;
     },
     [](const Options& o) -> OptionValue {
       return std::string(o.refine.kernel == Kernel::Cavity ? "cavity" : "swap");
     }},
    {"smoothing", false, set_smoothing,
     [](const Options& o) -> OptionValue { return std::int64_t{o.improve.sweeps}; }},
    {"repairs", false,
     [](Options& o, const Text& t) {
       o.improve.repairs = static_cast<int>(t.integer(0, kMostInt, kFromZero));
     },
     [](const Options& o) -> OptionValue { return std::int64_t{o.improve.repairs}; }},
    {"patches", false, set_patches, get_patches},
    {"quads", false, [](Options&, const Text& t) { t.expect({"false"}, {"true"}); },
     [](const Options&) -> OptionValue { return false; }},
    {"threads", false, set_threads, get_threads},
    {"max_elements", false,
     [](Options& o, const Text& t) {
       o.max_elements =
           static_cast<std::size_t>(t.integer(1, kMostExactInteger, "a whole number above 0"));
     },
     [](const Options& o) -> OptionValue { return static_cast<std::int64_t>(o.max_elements); }},
});

const OptionEntry& entry(std::string_view name) {
  const auto found = std::find_if(kOptions.begin(), kOptions.end(),
                                  [name](const OptionEntry& e) { return e.name == name; });
  if (found != kOptions.end()) return *found;
  const std::string front = fmt::format("there is no option '{}'", name.substr(0, kLongestQuote));
  if (name.size() <= kLongestQuote) {
    if (const auto near = nearest_word(name, option_names())) {
      throw Error(ErrorCode::InvalidOption, fmt::format("{}; did you mean {}?", front, *near));
    }
  }
  throw Error(ErrorCode::InvalidOption,
              fmt::format("{}; there are {}", front, fmt::join(option_names(), ", ")));
}

}  // namespace

const std::vector<std::string_view>& option_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> list;
    for (const OptionEntry& e : kOptions) list.push_back(e.name);
    return list;
  }();
  return names;
}

bool is_sizing_option(std::string_view name) { return entry(name).is_sizing; }

void set_option(PipelineOptions& options, std::string_view name, std::string_view value) {
  entry(name).set(options, OptionText(name, value));
}

OptionValue get_option(const PipelineOptions& options, std::string_view name) {
  return entry(name).get(options);
}

std::string to_text(const OptionValue& value) {
  return std::visit([](const auto& x) { return fmt::format("{}", x); }, value);
}

}  // namespace surfmesh
