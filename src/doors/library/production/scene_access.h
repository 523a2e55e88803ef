// Scenes with the options of the table in work/options.h, for doors that use the library.
#pragma once

#include <poinsot/scene.h>

#include <string>
#include <vector>

#include "orders/film.h"
#include "orders/options.h"

namespace poinsot::library {

// As the functions of Scene of these names; overrides keep their origin, which messages name.
struct SceneAccess {
    static Scene of(SceneRequest request);
    static Scene with(const Scene& scene, const std::vector<Override>& more);
    static Still still(const Scene& scene, const GivenOptions& given, const Watch& watch);
    // `format`: svg or pdf.
    static std::string figure(const Scene& scene, const GivenOptions& given,
                              const std::string& format, const Watch& watch);
    // A film, a page, a presentation or slides; in this process: several are the command line's.
    static void film(const Scene& scene, FilmOrder order, const GivenOptions& given,
                     const Watch& watch);
};

}  // namespace poinsot::library
