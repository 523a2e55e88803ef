// The colour and the alpha stored in a pixel of a shown picture.
#pragma once

namespace poinsot {

enum class ScreenAlpha { opaque, premultiplied, straight };

}  // namespace poinsot
