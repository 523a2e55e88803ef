// Limits of containers and clusters are respected.
#include "system/files/control_group.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "system/faults.h"
#include "system/files/processor.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class ControlGroup : public testing::Test {
 protected:
    ControlGroup() { fs::create_directories(root() / "slurm" / "job_7"); }

    const fs::path& root() const { return folder_.path(); }
    void write(const fs::path& file, const std::string& text) const {
        std::ofstream(root() / file) << text << '\n';
    }

 private:
    TemporaryFolder folder_;
};

TEST_F(ControlGroup, UsesTheSmallestLimitOfAllAncestors) {
    write("slurm/cpu.max", "150000 100000");
    write("slurm/memory.max", "8589934592");
    write("slurm/job_7/cpu.max", "max 100000");
    write("slurm/job_7/memory.max", "2147483648");
    const ResourceLimits limits =
        resource_limits_of(root(), "4:memory:/elsewhere\n0::/slurm/job_7\n");
    EXPECT_EQ(limits.n_processors, 1.5);
    EXPECT_EQ(limits.memory_bytes, 2147483648);
}

// A container sees its own group as the root.
TEST_F(ControlGroup, UsesTheRootGroupInsideAContainer) {
    write("cpu.max", "50000 100000");
    write("memory.max", "536870912");
    const ResourceLimits limits = resource_limits_of(root(), "0::/\n");
    EXPECT_EQ(limits.n_processors, 0.5);
    EXPECT_EQ(limits.memory_bytes, 536870912);
}

TEST_F(ControlGroup, HasNoLimitIfNoneIsSet) {
    write("slurm/cpu.max", "max 100000");
    write("slurm/memory.max", "max");
    for (const char* own : {"0::/slurm\n", "0::/gone/away\n", "1:cpu:/\n", "", "0::/"}) {
        const ResourceLimits limits = resource_limits_of(root(), own);
        EXPECT_FALSE(limits.n_processors) << own;
        EXPECT_FALSE(limits.memory_bytes) << own;
    }
    EXPECT_FALSE(resource_limits_of(root() / "nothing", "0::/slurm\n").memory_bytes);
}

TEST(Processor, ReportsAtLeastOneProcessorAndSomeMemory) {
    EXPECT_GE(n_processors(), 1);
    EXPECT_GT(memory_MiB(), 0);
}

}  // namespace
}  // namespace poinsot
