// SPDX-License-Identifier: BSD-3-Clause
#include "surfmesh/pipeline/set_option.hh"
#include "surfmesh/pipeline/option_table.hh"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/errors.hh"

namespace surfmesh {
namespace {

std::string fault(const std::string& name, const std::string& value) {
  PipelineOptions options;
  return error_of([&] { set_option(options, name, value); });
}

/// The value that an option has after it was set.
std::string after(const std::string& name, const std::string& value) {
  PipelineOptions options;
  set_option(options, name, value);
  return to_text(get_option(options, name));
}

TEST(SetOption, TakesBackTheDefaultOfEveryOption) {
  const PipelineOptions defaults;
  for (const std::string_view name : option_names()) {
    const std::string text = to_text(get_option(defaults, name));
    EXPECT_EQ(after(std::string(name), text), text) << name;
  }
}

TEST(SetOption, SetsEveryOptionThatIsBuilt) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"curvature", "0.5"},
                                                                  {"curvature", "off"},
                                                                  {"hmin", "0.07%"},
                                                                  {"hmax", "3.25"},
                                                                  {"stretch", "1"},
                                                                  {"grade", "1.25"},
                                                                  {"grade", "off"},
                                                                  {"nodes", "40000"},
                                                                  {"nodes", "auto"},
                                                                  {"precision", "0.01"},
                                                                  {"placement", "circumcentre"},
                                                                  {"kernel", "swap"},
                                                                  {"smoothing", "off"},
                                                                  {"smoothing", "best"},
                                                                  {"smoothing", "laplace"},
                                                                  {"smoothing", "element"},
                                                                  {"sweeps", "4"},
                                                                  {"conformity", "circle"},
                                                                  {"conformity", "0.5"},
                                                                  {"repairs", "7"},
                                                                  {"max_elements", "1000"}};
  for (const auto& [name, value] : cases) EXPECT_EQ(after(name, value), value) << name;
}

TEST(SetOption, ReachesTheStages) {
  PipelineOptions options;
  set_option(options, "hmin", "0.1%");
  set_option(options, "nodes", "100");
  set_option(options, "placement", "circumcentre");
  set_option(options, "kernel", "swap");
  set_option(options, "smoothing", "5");
  EXPECT_EQ(options.sizing.least_size().value, 0.001);
  EXPECT_TRUE(options.sizing.least_size().is_relative);
  EXPECT_EQ(options.control.regular_nodes, 100);
  EXPECT_EQ(options.refine.placement, Placement::Circumcentre);
  EXPECT_EQ(options.refine.kernel, Kernel::Swap);
  EXPECT_EQ(options.improve.smoothing, sweeps_of(5));
}

TEST(SetOption, TakesANumberForSmoothingInPlaceOfAKind) {
  PipelineOptions options;
  set_option(options, "smoothing", "laplace");
  set_option(options, "smoothing", "5");
  EXPECT_EQ(options.improve.smoothing, sweeps_of(5));
  EXPECT_EQ(to_text(get_option(options, "smoothing")), "5");
  set_option(options, "smoothing", "element");
  EXPECT_EQ(options.improve.smoothing, Smoothing::Element);
  EXPECT_EQ(options.improve.sweeps, ImproveOptions().sweeps);  // not those of before
  EXPECT_NE(fault("smoothing", "-3").find("off, best, laplace, element, or a whole number"),
            std::string::npos);
}

TEST(SetOption, SetsTheSizesOfContours) {
  PipelineOptions options;
  EXPECT_TRUE(options.sizing.contour_curvature && options.sizing.features);
  EXPECT_EQ(options.sizing.proximity, 1);
  set_option(options, "contour_curvature", "false");
  set_option(options, "features", "false");
  set_option(options, "proximity", "2.5");
  EXPECT_FALSE(options.sizing.contour_curvature || options.sizing.features);
  EXPECT_EQ(std::get<double>(get_option(options, "proximity")), 2.5);
  EXPECT_NE(fault("proximity", "-1"), "no error");
}

TEST(SetOption, SetsTheSag) {
  PipelineOptions options;
  set_option(options, "sag", "0.05%");
  EXPECT_EQ(to_text(get_option(options, "sag")), "0.05%");
  EXPECT_EQ(to_text(get_option(options, "curvature")), "off");
  for (const char* off : {"off", "0"}) {
    set_option(options, "sag", off);
    EXPECT_EQ(to_text(get_option(options, "sag")), "off");
    EXPECT_EQ(std::get<double>(get_option(options, "curvature")), 0.25);
    set_option(options, "sag", "2");
  }
  for (const char* bad : {"-1", "much", "0%"}) EXPECT_NE(fault("sag", bad), "no error") << bad;
}

TEST(SetOption, LeavesTheCurvatureThatIsGivenBesideTheSag) {
  PipelineOptions options;
  set_option(options, "curvature", "0.3");
  set_option(options, "sag", "0.05%");
  EXPECT_EQ(std::get<double>(get_option(options, "curvature")), 0.3);
}

TEST(SetOption, AcceptsTheOffValuesOfWhatIsNotBuilt) {
  const std::vector<std::pair<std::string, std::string>> cases = {{"quads", "false"},
                                                                  {"smoothing", "best"}};
  for (const auto& [name, value] : cases) EXPECT_EQ(fault(name, value), "no error") << name;
}

TEST(SetOption, SetsTheNumberOfThreads) {
  PipelineOptions options;
  EXPECT_EQ(to_text(get_option(options, "threads")), "all");
  set_option(options, "threads", "8");
  EXPECT_EQ(options.threads, 8);
  EXPECT_EQ(to_text(get_option(options, "threads")), "8");
  set_option(options, "threads", "all");
  EXPECT_EQ(options.threads, 0);
  EXPECT_EQ(
      fault("threads", "257"),
      "invalid option: threads = 257 is outside its range: all, or a whole number from 1 to 256");
}

TEST(SetOption, SetsWhatIsAPatchOfACage) {
  PipelineOptions options;
  EXPECT_EQ(to_text(get_option(options, "patches")), "auto");
  for (const auto& [value, kind] :
       {std::pair("faces", PatchKind::Faces), std::pair("blocks", PatchKind::Blocks),
        std::pair("regions", PatchKind::Regions), std::pair("auto", PatchKind::Auto)}) {
    set_option(options, "patches", value);
    EXPECT_EQ(options.patches, kind);
    EXPECT_EQ(to_text(get_option(options, "patches")), value);
  }
  EXPECT_EQ(fault("patches", "all"),
            "invalid option: patches = all is outside its range: auto, faces, blocks or regions");
}

TEST(SetOption, SetsHowControlSpacesAreMadeAndAsked) {
  PipelineOptions options;
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"control", "grid"}, {"interpolation", "o"}, {"epsilon", "0.2"},   {"blend", "log"},
      {"reuse", "0.5"},    {"lookup", "vertices"}, {"inner_nodes", "on"}};
  for (const auto& [name, value] : cases) {
    set_option(options, name, value);
    EXPECT_EQ(to_text(get_option(options, name)), value) << name;
  }
  const ControlOptions& control = options.control;
  EXPECT_EQ(control.kind, ControlKind::Grid);
  EXPECT_EQ(control.interpolation, Interpolation::Circles);
  EXPECT_EQ(control.epsilon, 0.2);
  EXPECT_EQ(control.blend, Blend::Logarithmic);
  EXPECT_EQ(control.reuse, 0.5);
  EXPECT_EQ(control.lookup, DiscLookup::Vertices);
  EXPECT_TRUE(control.inner_nodes);
}

TEST(SetOption, RefusesValuesOutOfTheirRange) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"curvature", "-1"},   {"curvature", "nan"}, {"curvature", "1x"}, {"curvature", ""},
      {"hmin", "0"},         {"hmin", "-1%"},      {"hmax", "101%"},    {"stretch", "0.9"},
      {"grade", "0.5"},      {"nodes", "3"},       {"nodes", "4.5"},    {"precision", "0"},
      {"placement", "best"}, {"kernel", "Cavity"}, {"smoothing", "-1"}, {"threads", "0"},
      {"max_elements", "0"}, {"quads", "yes"},     {"control", "none"}, {"nodes", "1e300"},
      {"epsilon", "0"},      {"reuse", "-0.1"},    {"lookup", "disk"},  {"interpolation", "x"}};
  for (const auto& [name, value] : cases) {
    const std::string front = "invalid option: " + name + " = " + value + " is outside its range: ";
    EXPECT_TRUE(fault(name, value).starts_with(front)) << fault(name, value);
  }
}

TEST(SetOption, RefusesWhatIsNoLength) {
  for (const std::string value : {"3mm", "1,5", "inf", "nan", "%", ""}) {
    EXPECT_EQ(fault("hmax", value), "invalid option: hmax = " + value +
                                        " cannot be read, it is a length above 0 in model units, "
                                        "or a share of the diagonal up to 100%");
  }
}

TEST(PipelineOptions, RefuseWhatSetOptionRefuses) {
  const auto error_with = [](auto change) {
    PipelineOptions options;
    change(options);
    return error_of([&] { check(options); });
  };
  EXPECT_EQ(error_with([](auto&) {}), "no error");
  EXPECT_EQ(error_with([](auto& o) { o.sizing.grade = 0.5; }), fault("grade", "0.5"));
  EXPECT_EQ(error_with([](auto& o) { o.sizing.hmax = Length::share(5); }), fault("hmax", "500%"));
  EXPECT_EQ(error_with([](auto& o) { o.sizing.sag = Length::units(-1); }), fault("sag", "-1"));
  EXPECT_EQ(error_with([](auto& o) { o.sizing.proximity = kUnset; }), fault("proximity", "nan"));
  EXPECT_EQ(error_with([](auto& o) { o.improve.sweeps = 0; }), fault("sweeps", "0"));
  EXPECT_EQ(error_with([](auto& o) { o.refine.conformity = -1; }), fault("conformity", "-1"));
  EXPECT_EQ(error_with([](auto& o) { o.threads = 257; }), fault("threads", "257"));
  EXPECT_EQ(error_with([](auto& o) { o.patches = static_cast<PatchKind>(9); }),
            fault("patches", "9"));
  EXPECT_EQ(error_with([](auto& o) { o.refine.kernel = static_cast<Kernel>(2); }),
            fault("kernel", "2"));
}

TEST(SetOption, LeavesTheOptionsAsTheyWereOnAFault) {
  PipelineOptions options;
  EXPECT_NE(error_of([&] { set_option(options, "grade", "0.5"); }), "no error");
  EXPECT_EQ(options.sizing.grade, Sizing{}.grade);
}

TEST(SetOption, SuggestsTheNearestName) {
  const std::string front = "invalid option: there is no option ";
  EXPECT_EQ(fault("hmn", "1"), front + "'hmn'; did you mean hmin?");
  EXPECT_EQ(fault("max-elements", "1"), front + "'max-elements'; did you mean max_elements?");
  EXPECT_EQ(fault("placment", "1"), front + "'placment'; did you mean placement?");
}

TEST(SetOption, ListsTheNamesWhereNoneIsNear) {
  const std::string error = fault("colour", "red");
  EXPECT_NE(error.find("'colour'; there are curvature, "), std::string::npos) << error;
  EXPECT_NE(error.find("max_elements"), std::string::npos) << error;
}

TEST(SetOption, KnowsWhatBelongsToTheSizing) {
  EXPECT_TRUE(find_option("hmin").group == OptionGroup::Sizes);
  EXPECT_TRUE(find_option("features").group == OptionGroup::Sizes);
  EXPECT_FALSE(find_option("nodes").group == OptionGroup::Sizes);
}

}  // namespace
}  // namespace surfmesh
