// The properties of a context.
#include <gtest/gtest.h>

#include "pictures.h"

namespace poinsot::testing {
namespace {

TEST(OffscreenContext, ReportsItsProperties) {
    close_shared_renderer();
    const OffscreenContext context(Backend::egl);
    EXPECT_EQ(context.info().backend, "EGL");
    EXPECT_FALSE(context.info().renderer.empty());
    EXPECT_GE(context.info().version.front(), '3');
    EXPECT_GE(context.info().largest_picture_px, 4096);
}

}  // namespace
}  // namespace poinsot::testing
