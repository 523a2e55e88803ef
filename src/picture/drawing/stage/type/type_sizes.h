// The one scale of the sizes of text, pixels per em at 1080 rows.
//
// On a screen, the title is the largest. Names in the picture come next, since they are read from
// the back row while the eye is on the picture: their small letters are a sixtieth of its height.
// The heading of a panel says what one looks at; it is dark. The caption is read once, between two
// looks. Charts have many words in little space: theirs are smaller (plot_frame.h), and no letter
// of a chart is larger than a name. On paper, which is read from near, names weigh less.
#pragma once

#include "drawing/stage/type/least_sizes.h"
#include "scene/scene.h"

namespace poinsot {

struct TypeSizes {
    double title, chapter, heading, vector_name, thing_name, caption;
};
inline constexpr TypeSizes screen_sizes{.title = 46.0,
                                        .chapter = 38.0,
                                        .heading = 34.0,
                                        .vector_name = 42.0,
                                        .thing_name = 40.6,
                                        .caption = 32.0};
inline constexpr TypeSizes paper_sizes{.title = 40.0,
                                       .chapter = 32.0,
                                       .heading = 36.5,
                                       .vector_name = 34.0,
                                       .thing_name = 27.2,
                                       .caption = 26.0};

// Size of names beside arrows on paper.
inline constexpr double label_size = paper_sizes.vector_name;

// The scale of text on paper relative to 1080 rows: that of lines, `px`, or a larger one at which a
// name and its subscript have their least sizes.
double paper_type_px(const Scene& scene, double px, const LeastSizes& least);

}  // namespace poinsot
