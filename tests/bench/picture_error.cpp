// picture_error SCENE [SIZE]: the difference of the picture from one with 64 samples per pixel,
// compared with that of four samples per pixel.
//
// The reference is drawn eight times as large and averaged in linear light. The four samples are
// those of its pixels at the positions of llvmpipe's multisampling (a rotated grid), which is the
// usual choice. Multisampling shades only once per pixel, so that its lines inside surfaces are
// coarser than here: the comparison favours it. Text is omitted: it does not depend on the number
// of samples.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "drawing/stage/stage.h"
#include "production/jobs/picture.h"
#include "production/session/session.h"
#include "scene/files/load_scene.h"
#include "typeset/files/installed_fonts.h"

namespace {

using namespace poinsot;

constexpr int side = 8;  // samples of the reference per side of a pixel

double linear(int level) {
    const double x = level / 255.0;
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}
double encoded(double x) {
    return 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
}

// Squared differences, in levels, over the counted pixels.
struct Sum {
    double square = 0.0, edge_square = 0.0;
    long n = 0, n_edge = 0;
    void add(double difference, bool edge) {
        square += difference * difference, ++n;
        if (edge) edge_square += difference * difference, ++n_edge;
    }
    double rms() const { return std::sqrt(square / static_cast<double>(n)); }
    double edge_rms() const { return std::sqrt(edge_square / static_cast<double>(n_edge)); }
    double psnr() const { return 20.0 * std::log10(255.0 / rms()); }
};

void run(const std::string& scene, const std::string& size) {
    const std::vector<std::string> overrides{"film.size=" + size, "title=", "caption="};
    const Session session = session_of(load_scene(scene, overrides), {installed_fonts()});
    const FilmPlan plan = film_plan(session);
    const double time_s = plan.time_of(plan.n_frames / 2);
    LazyRenderer renderer;
    const auto drawn = [&](int samples) {
        Session large = session;
        large.scene.film.width_px *= samples;
        large.scene.film.height_px *= samples;
        large.scene.accuracy_px *= samples;
        StageOptions options;
        options.fonts = installed_fonts();
        options.width_px = large.scene.film.width_px;
        options.height_px = large.scene.film.height_px;
        options.samples = samples;
        options.first_time_s = plan.time_of(0);
        options.last_time_s = time_s;
        const Stage stage(large.scene, large.theme, large.motion, options);
        Drawing drawing = stage.at(time_s);
        for (View& view : drawing.views) view.labels.clear();
        return renderer.renderer().render(drawing);
    };
    const Image picture = drawn(1);
    const Image fine = drawn(side);
    std::array<double, 256> light{};
    for (int level = 0; level < 256; ++level)
        light[static_cast<std::size_t>(level)] = linear(level);

    constexpr std::array<std::pair<int, int>, 4> samples{{{3, 1}, {7, 3}, {1, 5}, {5, 7}}};
    Sum analytic, four;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const auto sample = [&](int i, int j, int channel) {
                const std::size_t pixel = static_cast<std::size_t>(side * y + j) *
                                              static_cast<std::size_t>(fine.width()) +
                                          static_cast<std::size_t>(side * x + i);
                return fine.bytes()[4 * pixel + static_cast<std::size_t>(channel)];
            };
            const Rgba8 p = picture.at(x, y);
            const std::array<int, 3> levels{p.r, p.g, p.b};
            for (int c = 0; c < 3; ++c) {
                double sum = 0.0;
                int least = 255, most = 0;
                for (int j = 0; j < side; ++j) {
                    for (int i = 0; i < side; ++i) {
                        const std::uint8_t level = sample(i, j, c);
                        sum += light[level];
                        least = std::min<int>(least, level);
                        most = std::max<int>(most, level);
                    }
                }
                double sum_of_four = 0.0;
                for (const auto& [i, j] : samples) sum_of_four += light[sample(i, j, c)];
                const double reference = encoded(sum / (side * side));
                const bool edge = most - least > 8;
                analytic.add(levels[static_cast<std::size_t>(c)] - reference, edge);
                four.add(std::round(encoded(0.25 * sum_of_four)) - reference, edge);
            }
        }
    }
    fmt::print(
        "{{\"size\": \"{}\", \"edge_share\": {:.4f},\n \"picture\": {{\"psnr_db\": {:.2f}, "
        "\"rms\": "
        "{:.3f}, \"edge_rms\": {:.3f}}},\n \"four_samples\": {{\"psnr_db\": {:.2f}, \"rms\": "
        "{:.3f}, "
        "\"edge_rms\": {:.3f}}}}}\n",
        size, static_cast<double>(four.n_edge) / static_cast<double>(four.n), analytic.psnr(),
        analytic.rms(), analytic.edge_rms(), four.psnr(), four.rms(), four.edge_rms());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("picture_error SCENE [WxH]\n", stderr);
        return 2;
    }
    try {
        run(argv[1], argc > 2 ? argv[2] : "960x540");
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
}
