#include "encoding/quality.h"

#include "error/error.h"
#include "text/nearest.h"

namespace poinsot {

namespace {

// The settings of x264 lie on the Pareto front that x264_search.py of commit bc0084f1 found. At the
// similarity of the preset medium at crf 18 (SSIM 0.9969, default scene, 1920×1080) and with the
// lookahead of their presets, "lecture" takes 0.46 of its CPU time and 1.11 of its size, "print"
// 0.67 and 0.99, "reference" 1.31 and 0.93. psy would add grain, which drawings do not have;
// aq-mode 2 needs a tenth more bytes than aq-mode 1 for the same similarity. A short lookahead
// limits memory and the loss when a run is killed, which stays below a second from 24 frames a
// second on: 10 frames instead of 20 make a print film 1 % smaller and its SSIM 0.00015 less. A
// lookahead thread, with sync-lookahead frames waiting for it (4 by default), changes no byte: with
// 2 a lecture film takes 6 % less time and 20 MiB more; the qualities below and above gain nothing.
//
// libvpx has speed 8 in its realtime mode only.
//
// The figures are the rows of the same names from `poinsot tradeoff scenes/generic.toml`
// (2026-11-22, AMD EPYC, 2 cores, processor time); users see the times as ratios.
constexpr Quality quality_rows[] = {
    {.name = "draft",
     .x264 = {.preset = "ultrafast", .crf = "23", .parameters = "psy=0:sync-lookahead=0"},
     .vp9 = {.deadline = "realtime", .speed = "8", .crf = "36"},
     .summary = "curves within 5 × accuracy_px and the fastest encoder, for quick trials",
     .figures = {.picture_ms = 3.7,
                 .rms_levels = 0.96,
                 .film_ms = 2.7,
                 .film_kB = 10.4,
                 .film_ssim = 0.9881}},
    {.name = "lecture",
     .x264 = {.preset = "veryfast",
              .crf = "18",
              .parameters = "psy=0:aq-mode=1:trellis=1:sync-lookahead=2"},
     .vp9 = {.deadline = "realtime", .speed = "6", .crf = "28"},
     .summary = "the default: curves within accuracy_px/2, analytic anti-aliasing",
     .figures = {.picture_ms = 3.9,
                 .rms_levels = 0.64,
                 .film_ms = 6.6,
                 .film_kB = 5.6,
                 .film_ssim = 0.9916}},
    {.name = "print",
     .x264 = {.preset = "fast",
              .crf = "17",
              .parameters = "psy=0:aq-mode=1:rc-lookahead=10:sync-lookahead=0"},
     .vp9 = {.deadline = "good", .speed = "4", .crf = "24"},
     .summary = "curves within accuracy_px/4, also 2 × 2 samples per pixel, small files",
     .figures = {.picture_ms = 19.4,
                 .rms_levels = 0.37,
                 .film_ms = 11.6,
                 .film_kB = 6.0,
                 .film_ssim = 0.9930}},
    {.name = "reference",
     .x264 = {.preset = "slow",
              .crf = "14",
              .parameters = "psy=0:aq-mode=1:rc-lookahead=10:sync-lookahead=0"},
     .vp9 = {.deadline = "good", .speed = "2", .crf = "16"},
     .summary =
         "curves within accuracy_px/20, also 4 × 4 samples per pixel; the errors of the other "
         "qualities are measured against it",
     .figures = {.picture_ms = 54.5,
                 .rms_levels = 0.18,
                 .film_ms = 20.7,
                 .film_kB = 7.7,
                 .film_ssim = 0.9948}},
};

}  // namespace

std::span<const Quality> qualities() { return quality_rows; }

const Quality& quality_named(std::string_view name) {
    if (const Quality* row = find_row(quality_rows, name)) return *row;
    throw InputError(unknown("quality", name, names_of(quality_rows)));
}

}  // namespace poinsot
