// Where a picture shows its labels, its clock and its elements: recomputed from the picture's
// record.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/picture_region.h"
#include "production/records/record.h"

namespace poinsot {

// The names of regions: "labels", the overlays ("clock", …), the elements ("polhode", …) and the
// curves of panel body ("polhodes", "separatrix"). "polhode" also covers "polhodes".
std::vector<std::string_view> region_names();

// Makes the drawing of a record's picture again, without pixels. Move-only.
class PictureRegions {
 public:
    // Throws InputError for a record whose scene cannot be read here, and for a contact sheet.
    explicit PictureRegions(const Record& record);
    ~PictureRegions();
    PictureRegions(PictureRegions&&) noexcept;
    PictureRegions& operator=(PictureRegions&&) noexcept;

    // The rectangles that cover everything with these names, in pixels of a picture of this width;
    // `frame` of a film. Adds the names that are in the picture to `found`. Thin things have many
    // small rectangles, solids have one; each has a margin of 2 pixels.
    std::vector<PictureRegion> regions_of(std::span<const std::string> names, int picture_width,
                                          std::optional<std::int64_t> frame,
                                          std::set<std::string>& found) const;

 private:
    struct Impl;
    std::unique_ptr<const Impl> impl_;
};

}  // namespace poinsot
