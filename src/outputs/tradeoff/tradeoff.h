// The parts of `poinsot tradeoff`: motion, picture and film, each measured on this machine.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "production/session/session.h"
#include "production/stills/picture.h"

namespace poinsot {

// Marks the rows of the Pareto front: no other row is as good in both cost and error and better in
// one.
template <typename Row>
void mark_front(std::vector<Row>& rows, double Row::*cost, double Row::*error) {
    for (Row& row : rows) {
        row.on_front = std::none_of(rows.begin(), rows.end(), [&](const Row& other) {
            return other.*cost <= row.*cost && other.*error <= row.*error &&
                   (other.*cost < row.*cost || other.*error < row.*error);
        });
    }
}

// One row of the motion's table: a method with one setting.
struct MotionTrade {
    std::string method;   // with the order if it has several: "dmv-10"
    std::string setting;  // "step 0.01 s", "tolerance 1e-06", ""
    double ns_a_frame = 0.0;
    double evaluations_a_frame = 0.0;
    double attitude_rad = 0.0;
    // Relative drifts of T and L; not a number under a torque, which changes both.
    double energy = std::numeric_limits<double>::quiet_NaN();
    double momentum = std::numeric_limits<double>::quiet_NaN();
    double displacement_px = 0.0;
    bool on_front = false;
};

// Methods with several settings each, compared with a reference (the exact motion where it exists,
// else dopri5 with its smallest tolerance).
struct MotionTrades {
    std::string truth;
    int n_runs = 0;  // smallest number of any row
    std::int64_t n_frames = 0;
    std::vector<MotionTrade> rows;
};
MotionTrades trade_motion(const Session& session, const FilmPlan& film, double px_per_rad);

// One row of the picture's table.
struct PictureTrade {
    std::string setting;
    std::string quality;  // the name of --quality with these settings, or empty
    int samples = 1;      // per side of a pixel
    double ms_a_frame = 0.0;
    double rms_levels = 0.0;  // relative to the reference picture
    double largest_levels = 0.0;
    bool on_front = false;
};
struct PictureTrades {
    int width_px = 0, height_px = 0;
    int n_runs = 0;
    std::string reference;
    double film_ms = 0.0;  // per frame of the film itself, at its size and quality
    std::vector<PictureTrade> rows;
};
PictureTrades trade_picture(const Session& session, const ContextChoice& choice,
                            const FilmPlan& film);

// One row of the film's table: the encoder settings of a quality.
struct FilmTrade {
    std::string quality;
    double ms_a_frame = 0.0;  // processor time
    double bytes_a_frame = 0.0;
    double ssim = 0.0;
    double unlikeness = 1.0;  // 1 − ssim
    bool on_front = false;
};
struct FilmTrades {
    int width_px = 0, height_px = 0;
    std::int64_t n_frames = 0;
    std::vector<FilmTrade> rows;
};
FilmTrades trade_film(const Session& session, const ContextChoice& choice, const FilmPlan& film);

// All three tables.
struct Tradeoff {
    MotionTrades motion;
    PictureTrades picture;
    FilmTrades film;
};
Tradeoff trade(const Session& session, const ContextChoice& choice);

}  // namespace poinsot
