// How many words a phase is carried in.
#pragma once

namespace poinsot {

// How a closed form carries its phases. exact: in two words, so that no digit is lost with time.
// fast: in one word, cheaper, with an error that grows by the rounding of a product: by at most
// 2π·2^−53 = 7e-16 rad a turn for the turning about L and as much for that along the polhode, which
// is at most half as fast where the other is fastest. Over families of bodies it grows by 2e-16 in
// the mean and 7e-16 at most.
enum class Tier { exact, fast };

}  // namespace poinsot
