// How a pixel of a shown picture stores its colour beside its alpha.
#pragma once

namespace poinsot {

enum class ScreenAlpha { opaque, premultiplied, straight };

}  // namespace poinsot
