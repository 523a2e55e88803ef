#include "mechanics/regime.h"

namespace poinsot {

std::string_view name_of(Regime regime) {
    switch (regime) {
        case Regime::at_rest:
            return "at rest";
        case Regime::permanent:
            return "permanent rotation";
        case Regime::symmetric:
            return "symmetric body";
        case Regime::elliptic_about_lowest:
            return "elliptic, about the axis of the smallest moment";
        case Regime::elliptic_about_highest:
            return "elliptic, about the axis of the largest moment";
        case Regime::separatrix:
            return "separatrix";
        case Regime::heavy_top:
            return "heavy symmetric top";
        case Regime::integrated:
            return "integrated step by step";
    }
    return "";
}

}  // namespace poinsot
