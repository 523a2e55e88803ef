// Gives each test a temporary folder of its own, and fails the test that leaves something in it.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace poinsot {
namespace {

namespace fs = std::filesystem;

class LeftBehind : public ::testing::EmptyTestEventListener {
 public:
    void OnTestStart(const ::testing::TestInfo&) override {
        before_ = fs::temp_directory_path();
        std::string name = (before_ / "test-XXXXXX").string();
        folder_ = mkdtemp(name.data()) == nullptr ? fs::path() : fs::path(name);
        if (folder_.empty()) return;
        chmod(folder_.c_str(), 01777);  // some tests write as another user
        setenv("TMPDIR", folder_.c_str(), 1);
    }
    void OnTestEnd(const ::testing::TestInfo&) override {
        if (folder_.empty()) return;
        std::error_code error;
        for (fs::recursive_directory_iterator at(folder_, error), end; !error && at != end;
             at.increment(error))
            ADD_FAILURE() << "left behind in the temporary folder: "
                          << at->path().lexically_relative(folder_);
        fs::remove_all(folder_, error);
        setenv("TMPDIR", before_.c_str(), 1);
    }

 private:
    fs::path before_, folder_;
};

[[maybe_unused]] const bool is_watching = [] {
    ::testing::UnitTest::GetInstance()->listeners().Append(new LeftBehind);
    return true;
}();

}  // namespace
}  // namespace poinsot
