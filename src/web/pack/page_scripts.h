// Which scripts a page carries, and how.
#pragma once

#include <array>
#include <string_view>

namespace poinsot {

// As they are: what unpacks the others.
inline constexpr std::array<std::string_view, 3> plain_scripts{"unpack.js", "loader.js",
                                                               "start.js"};

// Packed by LZMA, in the order in which they are joined.
inline constexpr std::array<std::string_view, 20> packed_scripts{
    "words.js",      "film.js",         "link.js",      "program.js", "view.js",
    "controls.js",   "grips.js",        "notes.js",     "figure.js",  "bar.js",
    "png_frames.js", "film_encoder.js", "film_file.js", "slides.js",  "make_film.js",
    "keys.js",       "address.js",      "options.js",   "page.js",    "scripting.js"};

// As they are: those that the workbench adds.
inline constexpr std::array<std::string_view, 8> workbench_scripts{
    "zip_reader.js",    "drafts.js",  "editor.js", "record.js",
    "measure_chart.js", "measure.js", "pptx.js",   "workbench.js"};

}  // namespace poinsot
