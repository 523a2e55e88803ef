// Least sizes of text and lines on paper.
#pragma once

namespace poinsot {

// In pixels of one picture; 0: no limit.
struct LeastSizes {
    double type_px = 0.0;    // an em
    double script_px = 0.0;  // em of sub- and superscripts
    double line_px = 0.0;    // a line's width

    // The same in a picture `factor` times as large.
    LeastSizes times(double factor) const {
        return {factor * type_px, factor * script_px, factor * line_px};
    }
};

}  // namespace poinsot
