// Hashes of frames as output.
#include <gtest/gtest.h>

#include "encoding/films.h"
#include "encoding/frame_sink.h"

namespace poinsot {
namespace {

TEST(Md5Sink, HashesTheBytesOfEveryFrame) {
    const TemporaryFolder folder;
    OutputPlan plan = small_plan(folder / "a.md5");
    plan.first_frame = 41;
    const auto sink = format_for(plan.path).open(plan);
    Image picture(1, 1);
    picture.set(0, 0, {'a', 'b', 'c', 'd'});
    sink->write(picture);
    sink->finish();
    // MD5 of "abcd", from md5sum.
    EXPECT_EQ(bytes_of(plan.path), "41 e2fc714c4727ee9395f324cd2e7f331f\n");
}

}  // namespace
}  // namespace poinsot
