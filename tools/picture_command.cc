// SPDX-License-Identifier: BSD-3-Clause
#include "picture_command.hh"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <set>

#include "mesh_command.hh"
#include "output_paths.hh"
#include "outputs.hh"
#include "standard_output.hh"
#include "surfmesh/core/error.hh"
#include "surfmesh/core/properties.hh"
#include "surfmesh/formats/mesh_endings.hh"
#include "surfmesh/formats/read_mesh.hh"
#include "surfmesh/io/input_file.hh"
#include "surfmesh/io/nearest_word.hh"
#include "surfmesh/quality/statistics.hh"

namespace surfmesh {
namespace {

constexpr const char* kPictureFooter =
    "Fields: patch, group; quality, size, stretch, length, of the metric that .om files keep;\n"
    "  shape, valence, of any mesh; sag, where a run with --sag has measured it. Without "
    "--colour,\n"
    "  patches have colours if there are several; \"--colour plain\" is one colour for all.\n"
    "Contours are borders, creases and other lines between patches; in meshes without patches,\n"
    "  edges at which faces meet at more than 40 degrees.\n"
    "Examples:\n"
    "  surfmesh picture knob.om -o knob.png --colour quality --azimuth 30\n"
    "  surfmesh picture wave.om -o wave.svg --plane wave --ellipses\n";

/// Widths of lines on a picture whose lesser side is so many pixels.
constexpr double kUsualSide = 600, kEdgeWidth = 0.55, kContourWidth = 1.3;

PictureFormat format_of_picture(const std::string& path) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".svg") return PictureFormat::Svg;
  if (ending == ".png") return PictureFormat::Png;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: the ending of a picture is .svg or .png", path));
}

/// "900x600", as two numbers of pixels; nothing for anything else.
std::optional<std::pair<std::size_t, std::size_t>> parse_size(const std::string& text) {
  const std::size_t cross = text.find('x');
  if (cross == text.npos) return std::nullopt;
  const auto number = [](std::string_view word) -> std::optional<std::size_t> {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number = error == std::errc() && end == word.data() + word.size();
    // Beyond any picture, so that their product is a number, too.
    return is_number ? std::optional(std::min<std::size_t>(value, 1U << 20U)) : std::nullopt;
  };
  const auto width = number(std::string_view(text).substr(0, cross)),
             height = number(std::string_view(text).substr(cross + 1));
  if (!width || !height) return std::nullopt;
  return std::pair(*width, *height);
}

std::string size_fault(const std::string& text) {
  return parse_size(text) ? "" : text + " is no size: give WIDTHxHEIGHT, 900x600";
}

std::string colour_fault(const std::string& name) {
  if (name == "plain") return {};
  try {
    find_mesh_field(name);
    return {};
  } catch (const Error& error) {
    return fmt::format("{}, and plain", error.what());
  }
}

/// How a mesh comes to have a field.
std::string lacks(MeshField field) {
  switch (field) {
    case MeshField::Patch:
      return "it has no patches: .om, .obj and .ply files keep them";
    case MeshField::Group:
      return "it has no groups of patches: .om, .obj and .ply files keep those of the model";
    case MeshField::Sag:
      return "its sag was not measured: mesh the model with --sag, and write the mesh to an .om "
             "file, which keeps it";
    default:
      return "it has no metric: mesh the model, and write the mesh to an .om file, which keeps it";
  }
}

std::optional<MeshField> choose_field(const MeshFile& file, const std::string& path,
                                      const std::string& name, bool is_in_plane) {
  if (name == "plain") return std::nullopt;
  if (name.empty()) {
    if (is_in_plane || !has_field(file.mesh, file.names, MeshField::Patch)) return std::nullopt;
    const auto& patches = file.mesh.property(require(file.mesh, keys::face_patch)).data_vector();
    const bool has_several = std::any_of(patches.begin(), patches.end(),
                                         [&](int patch) { return patch != patches.front(); });
    return has_several ? std::optional(MeshField::Patch) : std::nullopt;
  }
  const MeshField field = find_mesh_field(name).field;
  if (has_field(file.mesh, file.names, field)) return field;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: no colours of {}: {}", path, name, lacks(field)));
}

/// The patches of faces, ascending.
std::set<int> patches_of(const PolyMesh& mesh) {
  const auto patch_of = find(mesh, keys::face_patch);
  if (!patch_of.is_valid()) return {};
  const auto& patches = mesh.property(patch_of).data_vector();
  return {patches.begin(), patches.end()};
}

std::optional<int> number_of(const std::string& word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_number = error == std::errc() && end == word.data() + word.size();
  return is_number ? std::optional(number) : std::nullopt;
}

/// The patch of a name, or else of a number from 0.
std::optional<int> find_patch(const MeshFile& file, const std::string& word) {
  const auto& names = file.names.patches;
  const auto found = std::find(names.begin(), names.end(), word);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  return number_of(word);
}

/// Why a name is none of these: with the one that was meant, or some of those that there are.
std::string unknown_name(const std::string& word, const std::vector<std::string>& known,
                         const std::string& kind) {
  std::vector<std::string_view> words;
  for (const std::string& name : known) {
    if (!name.empty()) words.emplace_back(name);
  }
  std::string text = fmt::format("there is no {} {}", kind, word);
  if (const auto meant = nearest_word(word, words)) {
    return text + fmt::format(", did you mean {}?", *meant);
  }
  if (words.empty()) return text;
  constexpr std::size_t kShown = 8;
  const std::size_t count = std::min(words.size(), kShown);
  text += fmt::format(": there {} ", words.size() == 1 ? "is" : "are");
  for (std::size_t i = 0; i < count; ++i) text += fmt::format("{}{}", i > 0 ? ", " : "", words[i]);
  return text + (words.size() > count ? fmt::format(" and {} more", words.size() - count) : "");
}

/// The patch whose plane is drawn.
int plane_patch(const MeshFile& file, const std::string& path, const std::string& word) {
  if (!has_parameters(file.mesh)) {
    throw Error(
        ErrorCode::InvalidInput,
        fmt::format("{}: no plane of parameters: the mesh has no (u,v); mesh the model, and "
                    "write the mesh to an .om file, which keeps them",
                    path));
  }
  const std::optional<int> patch = find_patch(file, word);
  const std::set<int> patches = patches_of(file.mesh);
  if (!patch || *patch < 0 ||
      (!patches.contains(*patch) &&
       *patch >= static_cast<int>(std::max<std::size_t>(file.names.patches.size(), 1)))) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: {}", path, unknown_name(word, file.names.patches, "patch")));
  }
  if (!patches.contains(*patch) && !patches.empty()) {
    throw Error(ErrorCode::InvalidInput,
                fmt::format("{}: no face lies on the patch {}: its elements are wider than it",
                            path, word));
  }
  return *patch;
}

/// Which faces fill the picture: those of a patch or of a group.
std::vector<char> faces_of(const MeshFile& file, const std::string& path, const std::string& word) {
  std::set<int> wanted;
  std::vector<std::string> known = file.names.patches;
  for (const Group& group : file.names.groups) {
    known.push_back(group.name);
    if (group.name == word) wanted.insert(group.patches.begin(), group.patches.end());
  }
  if (const auto patch = find_patch(file, word); patch && wanted.empty()) wanted.insert(*patch);
  std::vector<char> shown(file.mesh.n_faces(), 0);
  bool has_any = false;
  if (const auto patch_of = find(file.mesh, keys::face_patch); patch_of.is_valid()) {
    for (const FaceHandle fh : file.mesh.faces()) {
      shown[index(fh)] = wanted.contains(file.mesh.property(patch_of, fh)) ? 1 : 0;
      has_any = has_any || shown[index(fh)] != 0;
    }
  }
  if (has_any) return shown;
  throw Error(ErrorCode::InvalidInput,
              fmt::format("{}: {}", path,
                          wanted.empty() ? unknown_name(word, known, "patch or group")
                                         : fmt::format("no face lies on {}", word)));
}

/// A check that the help does not show.
CLI::Validator quiet(CLI::Validator check) { return check.description(""); }

CLI::Option* add_switch(CLI::App& command, const char* flag, std::string& value, const char* text) {
  return command.add_option(flag, value, text)
      ->check(quiet(CLI::IsMember({"on", "off"})))
      ->type_name("on|off");
}

}  // namespace

void PictureCommand::add_to(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("picture", "Draw a mesh, in space or in the parameters of a patch.");
  command->footer(kPictureFooter);
  command->add_option("MESH", mesh_, "mesh to draw: " + readable_mesh_endings())
      ->required()
      ->type_name("");
  command->add_option("-o,--output", output_, "picture to write: .svg or .png")
      ->required()
      ->type_name("OUT");
  command->add_option("--colour,--color", colour_, "field that gives the colours, or plain")
      ->check(colour_fault)
      ->type_name("FIELD");
  command->add_option("--size", size_, "pixels (900x600)")->type_name("WxH")->check(size_fault);
  add_view(*command);
  add_style(*command);
  command->add_flag("--quiet", is_quiet_, "print warnings and errors only");
}

void PictureCommand::add_view(CLI::App& command) {
  constexpr double kGreatestZoom = 1000;
  const auto number = [&](const char* flag, double& value, const char* text, double least,
                          double greatest) {
    return command.add_option(flag, value, text)
        ->check(quiet(CLI::Range(least, greatest)))
        ->type_name("X");
  };
  const std::vector<CLI::Option*> of_space = {
      number("--azimuth", camera_.azimuth, "degrees around the upward axis, of the camera (-60)",
             -360, 360),
      number("--elevation", camera_.elevation, "degrees of the camera above the horizon (30)", -90,
             90),
      command.add_option("--up", up_, "axis that is upwards: x, y or z (z)")
          ->check(quiet(CLI::IsMember({"x", "y", "z"})))
          ->type_name("AXIS"),
      command.add_flag("--perspective", is_perspective_,
                       "perspective instead of parallel projection"),
      number("--zoom", zoom_, "magnification; 1 fits the picture", 1 / kGreatestZoom,
             kGreatestZoom),
      command.add_option("--look-at", look_at_, "point in the middle of the picture: X,Y,Z")
          ->delimiter(',')
          ->expected(3)
          ->type_name("POINT"),
      command.add_option("--fit", fit_, "patch or group that fills the picture")
          ->type_name("NAME")};
  CLI::Option* plane = command
                           .add_option("--plane", plane_,
                                       "patch, by name or number from 0: show its (u,v), not space")
                           ->type_name("PATCH");
  for (CLI::Option* option : of_space) plane->excludes(option);
  command.add_flag("--ellipses", has_ellipses_, "the metric as ellipses over the plane")
      ->needs(plane);
}

void PictureCommand::add_style(CLI::App& command) {
  constexpr double kGreatestWidth = 100;
  add_switch(command, "--edges", edges_, "sides of all faces (on)");
  add_switch(command, "--contours", contours_, "borders, creases and lines between patches (on)");
  add_switch(command, "--key", key_, "what the colours mean, to the right (on)");
  command
      .add_option("--line-width", line_width_,
                  "edge width in pixels (default: scales with the picture)")
      ->check(quiet(CLI::Range(0.0, kGreatestWidth)))
      ->type_name("X");
  command
      .add_option("--contour-width", contour_width_,
                  "contour width in pixels (default: scales with the picture)")
      ->check(quiet(CLI::Range(0.0, kGreatestWidth)))
      ->type_name("X");
  command.add_option("--background", background_, "white, or none for transparent (white)")
      ->check(quiet(CLI::IsMember({"white", "none"})))
      ->type_name("COLOUR");
}

PictureOptions PictureCommand::options_for(const MeshFile& file) const {
  PictureOptions options;
  std::tie(options.width, options.height) = *parse_size(size_);
  const double scale = double(std::min(options.width, options.height)) / kUsualSide;
  options.lines = {edges_ == "on", contours_ == "on",
                   line_width_ > 0 ? line_width_ : std::max(0.3, scale * kEdgeWidth),
                   contour_width_ > 0 ? contour_width_ : std::max(0.7, scale * kContourWidth)};
  options.has_key = key_ == "on";
  options.is_transparent = background_ == "none";
  options.has_ellipses = has_ellipses_;
  options.colour = choose_field(file, mesh_, colour_, !plane_.empty());
  if (!plane_.empty()) {
    options.plane = plane_patch(file, mesh_, plane_);
    if (has_ellipses_ && !has_metric(file.mesh)) {
      throw Error(ErrorCode::InvalidInput,
                  fmt::format("{}: no ellipses: {}", mesh_, lacks(MeshField::Size)));
    }
    return options;
  }
  options.view.camera = camera_;
  options.view.camera.up = up_ == "x" ? Axis::X : up_ == "y" ? Axis::Y : Axis::Z;
  options.view.camera.lens = is_perspective_ ? Lens::Perspective : Lens::Parallel;
  options.view.zoom = zoom_;
  if (!look_at_.empty()) options.view.look_at = {look_at_[0], look_at_[1], look_at_[2]};
  if (!fit_.empty()) options.view.shown = faces_of(file, mesh_, fit_);
  return options;
}

int PictureCommand::draw() const {
  const PictureFormat format = format_of_picture(output_);
  check_mesh_ending(mesh_);
  check_writable(output_);
  check_not_overwritten(std::array{std::filesystem::path(mesh_)}, output_);
  const MeshFile file = read_mesh(mesh_);
  throw_if_signalled();
  const PictureOptions options = options_for(file);
  const std::string picture = draw_mesh(file.mesh, file.names, options, format);
  throw_if_signalled();
  Outputs outputs;
  outputs.add(output_).write(picture);
  outputs.commit(kDone);
  int status = kDone;
  if (!is_quiet_) {
    status = print_summary(fmt::format("{}: {} x {} pixels, {} bytes\n", output_, options.width,
                                       options.height, picture.size()),
                           status);
  }
  print_notices(file.notices, {.is_quiet = is_quiet_});
  return status;
}

int PictureCommand::run() const {
  catch_signals();
  Progress progress(false);
  try {
    return draw();
  } catch (const std::exception& error) {
    return tell_failure(error, progress);
  }
}

}  // namespace surfmesh
