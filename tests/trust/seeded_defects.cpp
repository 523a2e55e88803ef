// Prints which seeded defects a comparison with the default limits detects, and checks that it
// accepts the differences between processors (noise). Exit code 1 if a defect is missed or noise is
// rejected.
//
// seeded_defects: all tests; noise also under qemu, if installed.
// seeded_defects --draw FOLDER: draws the pictures for the noise, in the native profile.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "drawing/stage/stage.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "places.h"
#include "production/session/session.h"
#include "render/renderer.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

// In the middle of the motion, while the herpolhode is growing.
constexpr double shown_at_s = 3.0;
constexpr double frame_length_s = 1.0 / 30.0;

struct Size {
    int width_px, height_px;
};

// A scene that can be drawn at any instant.
struct Subject {
    Session session;
    Stage stage;

    Subject(Scene scene, const Size& size)
        : session(session_of(scene, {installed_fonts()})),
          stage(session.scene, session.theme, session.motion,
                {.width_px = size.width_px,
                 .height_px = size.height_px,
                 .last_time_s = 10.0,
                 .fonts = installed_fonts()}) {}
};

Scene scene_named(const std::string& name) {
    return load_scene(source_folder() / "scenes" / (name + ".toml"));
}

// Half a pixel to the right, at the distance of the view's target.
Eigen::Vector3d half_pixel(const View& view) {
    const Eigen::Vector3d ahead = view.camera.target - view.camera.eye;
    const double units_per_px = 2.0 * std::tan(view.camera.vertical_field_rad / 2.0) *
                                ahead.norm() / static_cast<double>(view.height_px);
    return 0.5 * units_per_px * ahead.cross(view.camera.up).normalized();
}

// The herpolhode itself, not its light edge.
Curve* herpolhode_of(View& view) {
    for (Curve& curve : view.curves)
        if (curve.on_plane >= 0 && curve.name.element == "herpolhode" && curve.name.part.empty())
            return &curve;
    return nullptr;
}

// A change of the drawing, as small as a realistic mistake.
struct Defect {
    std::string name;
    std::function<void(Drawing& drawing, const Stage& stage)> make;
    bool removes_curve = false;
};

std::vector<Defect> drawing_defects(std::size_t n_curves) {
    std::vector<Defect> defects{
        {"light +0.005", [](Drawing& d, const Stage&) { d.views[0].light.key += 0.005; }},
        {"colour +0.015",
         [](Drawing& d, const Stage&) { d.views[0].ellipsoids.at(0).colour.g += 0.015; }},
        {"one axis +0.3 %",
         [](Drawing& d, const Stage&) { d.views[0].ellipsoids.at(0).half_axes.col(0) *= 1.003; }},
        {"body's edge moved 0.5 px",
         [](Drawing& d, const Stage&) {
             d.views[0].ellipsoids.at(0).centre += half_pixel(d.views[0]);
         }},
        {"curve's edge moved 0.5 px",
         [](Drawing& d, const Stage&) {
             herpolhode_of(d.views[0])->placement.pretranslate(half_pixel(d.views[0]));
         }},
        {"herpolhode one frame late", [](Drawing& d, const Stage& stage) {
             Drawing before = stage.at(shown_at_s - frame_length_s);
             herpolhode_of(d.views[0])->last = herpolhode_of(before.views[0])->last;
             // With the original contact point, which covers the curve's end.
             d.views[0].dots = before.views[0].dots;
         }}};
    for (std::size_t i = 0; i < n_curves; ++i)
        defects.push_back({fmt::format("curve {} of {} missing", i + 1, n_curves),
                           [i](Drawing& d, const Stage&) {
                               auto& curves = d.views[0].curves;
                               curves.erase(curves.begin() + static_cast<std::ptrdiff_t>(i));
                           },
                           true});
    return defects;
}

// The largest component of ω, changed by one in its fourth digit.
Scene with_wrong_omega(Scene scene) {
    Eigen::Vector3d& omega = scene.start.omega_rad_s;
    Eigen::Index largest = 0;
    omega.cwiseAbs().maxCoeff(&largest);
    omega[largest] += std::pow(10.0, std::floor(std::log10(std::abs(omega[largest]))) - 3.0);
    return scene;
}

// Prints one line of the table. Returns whether the result is as expected.
bool print_row(const std::string& picture, const std::string& what, const Comparison& found,
               bool must_fail) {
    const auto percent = [&](std::int64_t n) {
        return 100.0 * static_cast<double>(n) / static_cast<double>(found.n_pixels);
    };
    const bool right = found.passes() != must_fail;
    fmt::print("{:24} {:28} {:9.4f} % {:9.4f} % {:4}  {}\n", picture, what,
               percent(found.n_differing), percent(found.n_over_level), found.largest_difference,
               must_fail ? (right ? "caught" : "MISSED") : (right ? "let pass" : "TAKEN FOR ONE"));
    std::fflush(stdout);
    return right;
}

// Every defect of one scene at one size; returns how many rows are wrong.
int defects_of(const std::string& name, const Size& size, Renderer& renderer) {
    const std::string picture = fmt::format("{} {}×{}", name, size.width_px, size.height_px);
    const Subject subject(scene_named(name), size);
    const Image good = renderer.render(subject.stage.at(shown_at_s));
    int n_wrong = 0;
    const std::size_t n_curves = subject.stage.at(shown_at_s).views.at(0).curves.size();
    for (const Defect& defect : drawing_defects(n_curves)) {
        Drawing drawing = subject.stage.at(shown_at_s);
        defect.make(drawing, subject.stage);
        const Comparison found = compare(good, renderer.render(drawing));
        // A curve of which other things leave no more than a trace is not in the picture.
        const bool is_seen =
            !defect.removes_curve || found.largest_difference > CompareLimits{}.level;
        n_wrong += !print_row(picture, defect.name, found, is_seen);
    }
    const Subject wrong(with_wrong_omega(scene_named(name)), size);
    n_wrong += !print_row(picture, "omega wrong in 4th digit",
                          compare(good, renderer.render(wrong.stage.at(shown_at_s))), true);
    return n_wrong;
}

// A picture drawn on other processors. One process draws all of them on each processor: under qemu,
// compiling the shaders takes most of the time.
struct NoisePicture {
    const char* name;
    Size size;
};
constexpr std::array<NoisePicture, 4> noise_pictures = {{{"generic", {240, 135}},
                                                         {"tennis_racket", {240, 135}},
                                                         {"generic", {960, 540}},
                                                         {"tennis_racket", {960, 540}}}};

fs::path file_of(const fs::path& folder, const NoisePicture& picture) {
    return folder / fmt::format("{}-{}.png", picture.name, picture.size.width_px);
}

// Runs this program in a child process, as another processor ("" for this one).
bool draw_elsewhere(const std::string& processor, const fs::path& folder) {
    const std::string self = fs::read_symlink("/proc/self/exe");
    std::vector<std::string> words;
    if (!processor.empty()) words = {"qemu-x86_64", "-cpu", processor};
    for (const std::string& word : {self, std::string("--draw"), folder.string()})
        words.push_back(word);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        unsetenv("GALLIUM_OVERRIDE_CPU_CAPS");  // set for the portable profile of this process
        setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
        if (freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
        execvp(arguments[0], arguments.data());
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// Compares the pictures of other processors, in the native profile.
int noise(Renderer& renderer) {
    std::vector<Image> good;
    good.reserve(noise_pictures.size());
    for (const NoisePicture& picture : noise_pictures)
        good.push_back(
            renderer.render(Subject(scene_named(picture.name), picture.size).stage.at(shown_at_s)));
    const fs::path folder = fs::temp_directory_path() / fmt::format("poinsot-noise-{}", ::getpid());
    fs::create_directory(folder);
    int n_wrong = 0;
    for (const std::string processor : {"", "Haswell", "EPYC"}) {
        const std::string what = "noise, " + (processor.empty() ? "this machine" : processor);
        const bool drawn = draw_elsewhere(processor, folder);
        for (std::size_t i = 0; i < noise_pictures.size(); ++i) {
            const auto& [name, size] = noise_pictures[i];
            const std::string picture =
                fmt::format("{} {}×{}", name, size.width_px, size.height_px);
            if (!drawn) {
                fmt::print("{:24} {:28} cannot be run here\n", picture, what);
                continue;
            }
            const fs::path file = file_of(folder, noise_pictures[i]);
            n_wrong += !print_row(picture, what, compare(good[i], read_png(file)), false);
            fs::remove(file);
        }
    }
    fs::remove_all(folder);
    return n_wrong;
}

int draw_native(const fs::path& folder) {
    const OffscreenContext context(Backend::automatic, Portability::native);
    Renderer renderer(context);
    for (const NoisePicture& picture : noise_pictures) {
        const Subject subject(scene_named(picture.name), picture.size);
        write_png(file_of(folder, picture), renderer.render(subject.stage.at(shown_at_s)));
    }
    return 0;
}

int print_table() {
    const OffscreenContext context(Backend::automatic, Portability::portable);
    Renderer renderer(context);
    const CompareLimits caps;
    fmt::print(
        "caps: {:g} % differ, {:g} % by more than {} levels\n\n{:24} {:28} {:>11} {:>11} "
        "{:>5}\n",
        100 * caps.differing_share, 100 * caps.over_level_share, caps.level, "picture", "change",
        "differ", "over", "most");
    int n_wrong = 0;
    for (const Size& size : {Size{240, 135}, Size{960, 540}, Size{1920, 1080}})
        for (const char* name : {"generic", "tennis_racket"})
            n_wrong += defects_of(name, size, renderer);
    n_wrong += noise(renderer);
    fmt::print("\n{} rows are not as they should be\n", n_wrong);
    return n_wrong == 0 ? 0 : 1;
}

}  // namespace
}  // namespace poinsot

int main(int argc, char** argv) {
    try {
        if (argc == 3 && std::string(argv[1]) == "--draw") return poinsot::draw_native(argv[2]);
        return poinsot::print_table();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
