// A tennis racket that is thrown so that it turns about its middle axis: when does it flip over?
#include <poinsot/construction.h>
#include <poinsot/error.h>
#include <poinsot/motion.h>

#include <cmath>
#include <cstdio>
#include <numbers>

int main() {
    using namespace poinsot::library;
    try {
        // Moments in kg m² about the axes out of the face, across the handle, and along the handle.
        const Motion racket({17.1e-3, 15.6e-3, 1.57e-3}, {0.3, 6.2832, 0.2});
        std::printf("%s\n", racket.regime_sentence().c_str());
        const Constants constants = racket.constants();
        std::printf("period_s %.17g\n", constants.polhode_period_s.value());
        std::printf("precession_rad_s %.17g\n", constants.precession_rad_s);

        const Construction construction(racket);
        for (const double time_s : construction.flips(0.0, 2.0 * *constants.polhode_period_s))
            std::printf("flip_s %.17g\n", time_s);

        // The contact point lies in the invariable plane, at every instant.
        const ContactPoint contact = construction.contact(1000.0);
        std::printf("contact %.17g %.17g %.17g\n", contact.body[0], contact.body[1],
                    contact.body[2]);
        std::printf("plane_distance %.17g\n", construction.plane_distance());
        const double height = contact.space.dot(construction.normal_space());
        std::printf("contact_height %.17g\n", height);
        std::printf("omega_from_L_deg %.17g\n",
                    std::acos(height / contact.space.norm()) * 180.0 / std::numbers::pi);

        // Moments that no body has: the message says why.
        try {
            const Motion impossible({1.0, 1.0, 3.0}, {1.0, 0.0, 0.0});
        } catch (const poinsot::InputError& error) {
            std::printf("error %s\n", error.what());
        }
    } catch (const poinsot::Error& error) {
        std::fprintf(stderr, "racket: %s\n", error.what());
        return 1;
    }
    return 0;
}
