// Speed versus accuracy of the picture, for one scene: settings compared with a reference of 8 × 8
// samples per pixel.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "drawing/style/picture_quality.h"
#include "production/stills/picture.h"
#include "tradeoff/measure.h"
#include "tradeoff/tradeoff.h"

namespace poinsot {

namespace {

struct Setting {
    double curve_tolerance;
    int samples;
};

constexpr std::array<Setting, 9> settings{
    {{100.0, 1}, {10.0, 1}, {1.0, 1}, {0.1, 1}, {10.0, 2}, {1.0, 2}, {0.5, 2}, {0.5, 3}, {0.1, 4}}};

std::string quality_of(const Setting& setting) {
    for (const PictureQuality& quality : picture_qualities()) {
        if (quality.curve_tolerance == setting.curve_tolerance &&
            quality.samples == setting.samples) {
            return std::string(quality.name);
        }
    }
    return "";
}

struct Difference {
    double rms = 0.0;
    double largest = 0.0;
};

Difference difference_between(const Image& a, const Image& b) {
    Difference difference;
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bytes().size(); ++i) {
        const double d = std::abs(static_cast<double>(a.bytes()[i]) - b.bytes()[i]);
        sum += d * d;
        difference.largest = std::max(difference.largest, d);
    }
    // Alpha is equal everywhere and does not count.
    difference.rms = std::sqrt(sum / (0.75 * static_cast<double>(a.bytes().size())));
    return difference;
}

}  // namespace

PictureTrades trade_picture(const Session& session, const ContextChoice& choice,
                            const FilmPlan& film) {
    // Half the film's sides: the errors are those of edges and lines, which do not depend on the
    // size, and text at a corner stays on whole pixels for any number of samples.
    Session small = session;
    PictureTrades trades;
    trades.width_px = small.scene.film.width_px = std::max(16, session.scene.film.width_px / 2);
    trades.height_px = small.scene.film.height_px = std::max(16, session.scene.film.height_px / 2);
    small.accuracy = accuracy_of(small.scene);
    trades.n_runs = 1000;

    constexpr int reference_samples = 8;
    constexpr double reference_tolerance = 0.02;
    trades.reference = fmt::format("{0} × {0} samples a pixel, curves within {1} accuracy_px",
                                   reference_samples, 0.5 * reference_tolerance);
    const PictureSpan span{film.time_of(0), film.last_time_s()};
    const std::array<FilmTime, 3> moments{film.moment_of(film.n_frames / 4),
                                          film.moment_of(film.n_frames / 2),
                                          film.moment_of(film.n_frames - 1)};

    const OffscreenContext context = make_context(choice);
    std::array<Image, 3> references;
    {
        PictureMaker maker(small, context, span, {reference_tolerance, reference_samples});
        for (std::size_t i = 0; i < moments.size(); ++i) maker.draw(moments[i], references[i]);
    }
    for (const Setting& setting : settings) {
        PictureMaker maker(small, context, span, {setting.curve_tolerance, setting.samples});
        PictureTrade row;
        row.setting =
            fmt::format("curves {:g} × accuracy_px, {}", 0.5 * setting.curve_tolerance,
                        setting.samples == 1 ? std::string("analytic edges alone")
                                             : fmt::format("{0} × {0} samples", setting.samples));
        row.quality = quality_of(setting);
        row.samples = setting.samples;
        Image image;
        double sum = 0.0;
        for (std::size_t i = 0; i < moments.size(); ++i) {
            maker.draw(moments[i], image);
            const Difference difference = difference_between(references[i], image);
            sum += difference.rms * difference.rms;
            row.largest_levels = std::max(row.largest_levels, difference.largest);
        }
        row.rms_levels = std::sqrt(sum / static_cast<double>(moments.size()));
        const Timing timing = timed([&] {
            for (const FilmTime& moment : moments) maker.draw(moment, image);
        });
        row.ms_a_frame = timing.cpu_s / static_cast<double>(moments.size()) * 1e3;
        trades.n_runs = std::min(trades.n_runs, timing.n_runs);
        trades.rows.push_back(row);
    }
    mark_front(trades.rows, &PictureTrade::ms_a_frame, &PictureTrade::rms_levels);
    {
        PictureMaker maker(session, context, span, setting_of(session.scene));
        Image image;
        const Timing timing = timed([&] {
            for (const FilmTime& moment : moments) maker.draw(moment, image);
        });
        trades.film_ms = timing.cpu_s / static_cast<double>(moments.size()) * 1e3;
    }
    return trades;
}

}  // namespace poinsot
