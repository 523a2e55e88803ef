// How small type and lines may be on paper.
#pragma once

namespace poinsot {

// In pixels of one picture; 0: as small as it comes.
struct LeastSizes {
    double type_px = 0.0;    // an em
    double script_px = 0.0;  // of sub- and superscripts
    double line_px = 0.0;    // a line's width

    // In a picture so many times as large.
    LeastSizes times(double factor) const {
        return {factor * type_px, factor * script_px, factor * line_px};
    }
};

}  // namespace poinsot
