// A rectangle of a picture.
#pragma once

namespace poinsot {

// In pixels; it may extend beyond the picture.
struct PictureRegion {
    int left = 0, top = 0, width = 0, height = 0;
    bool operator==(const PictureRegion&) const = default;
};

}  // namespace poinsot
