#include "cli/options.h"

#include <fmt/format.h>

#include "cli/option_values.h"
#include "cli/scenes.h"
#include "drawing/style/theme.h"
#include "error/error.h"
#include "output/quality.h"
#include "text/printable.h"

namespace poinsot {

namespace {

// An option that sets a scene key. A bare word becomes a TOML string; numbers stay numbers.
Option override_option(SceneOptions& scene, const char* flag, const char* key,
                       const std::string& help, const char* takes, const char* completes = "") {
    return {
        .flags = flag,
        .takes = takes,
        .help = help,
        .value = ReadText{[&scene, flag, key](const std::string& value) {
            scene.overrides.push_back(fmt::format("{} {}={}", flag, key, parse_text(flag, value)));
        }},
        .completes = completes};
}

// Joins the names of a table's rows: "light, dark or print".
template <typename Rows>
std::string listed(const Rows& rows) {
    std::string names;
    for (std::size_t i = 0; i < rows.size(); ++i)
        names += fmt::format("{}{}",
                             i == 0                ? ""
                             : i + 1 < rows.size() ? ", "
                                                   : " or ",
                             rows[i].name);
    return names;
}

}  // namespace

Option set_option(SceneOptions& scene) {
    return {.flags = "--set",
            .takes = "KEY=VALUE",
            .help = "set any scene key; repeatable",
            .value = Repeated{&scene.overrides},
            .completes = "keys"};
}

Option size_option(SceneOptions& scene) {
    return override_option(scene, "--size", "film.size", "picture size in pixels", "WxH");
}

Option fps_option(SceneOptions& scene) {
    return override_option(scene, "--fps", "film.fps", "video frames per second", "N[/D]");
}

Option quality_option(SceneOptions& scene) {
    return override_option(scene, "--quality", "film.quality", listed(qualities()), "NAME",
                           "qualities");
}

Option theme_option(SceneOptions& scene) {
    return override_option(scene, "--theme", "theme",
                           listed(themes()) + ", or the path of a theme file (.toml)", "NAME",
                           "themes");
}

Option allow_outside_option(bool& allow_outside) {
    return {.flags = "--allow-outside",
            .help = "allow the scene to name files outside its folder",
            .value = &allow_outside};
}

SceneRequest scene_request_of(const std::string& file, const SceneOptions& options,
                              const std::vector<std::string>& more_overrides) {
    SceneRequest request;
    request.file = scene_file(file);
    request.overrides = options.overrides;
    request.overrides.insert(request.overrides.end(), more_overrides.begin(), more_overrides.end());
    request.outside = outside_files(options.allow_outside);
    return request;
}

OutsideFiles outside_files(bool allow_outside) {
    return allow_outside ? OutsideFiles::allowed : OutsideFiles::refused;
}

Option backend_option(BackendOptions& context) {
    return {.flags = "--backend",
            .takes = "NAME",
            .help = "auto, osmesa or egl (software), or gpu",
            .value = &context.backend,
            .completes = "auto|osmesa|egl|gpu"};
}

Option portable_option(BackendOptions& context) {
    return {.flags = "--portable",
            .help = "write the same bytes on every x86-64 processor",
            .value = &context.portable};
}

ContextChoice context_choice_of(const BackendOptions& options) {
    return context_choice(options.backend, options.portable);
}

Option output_option(std::string& output, std::string_view help) {
    return {.flags = "-o,--output",
            .takes = "FILE",
            .help = std::string(help),
            .value = &output,
            .completes = "file"};
}

Option json_option(bool& json, std::string_view help) {
    return {.flags = "--json", .help = std::string(help), .value = &json};
}

Option quiet_option(bool& quiet) {
    return {.flags = "--quiet,-q", .help = "hide progress and notes", .value = &quiet};
}

}  // namespace poinsot
