// The OpenGL that this build draws with.
#pragma once

namespace poinsot {

// Desktop OpenGL 3.3; in a browser WebGL 2, which is OpenGL ES 3.0: it has no multisampled
// textures, and shows the picture instead of handing it over.
enum class Dialect { desktop, es };
#ifdef __wasm__
inline constexpr Dialect dialect = Dialect::es;
#else
inline constexpr Dialect dialect = Dialect::desktop;
#endif

}  // namespace poinsot
