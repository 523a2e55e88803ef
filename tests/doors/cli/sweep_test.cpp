// --sweep and --sheet: several runs of one scene.
#include "cli/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/program_run.h"
#include "error/error.h"
#include "image/files/png_files.h"

namespace poinsot::testing::sweep_tests {
namespace {

namespace fs = std::filesystem;

constexpr const char* a_scene = R"(title = "Swept"
[body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.3, 2.0, 0.1]
[film]
size = [192, 108]
duration_s = 0.1
)";

TEST(Sweep, ReadsListsAndRanges) {
    using Values = std::vector<std::string>;
    EXPECT_EQ(parse_sweep("a.b=1,2.5,x").values, (Values{"1", "2.5", "x"}));
    EXPECT_EQ(parse_sweep("a=0:1:5").values, (Values{"0", "0.25", "0.5", "0.75", "1"}));
    EXPECT_EQ(parse_sweep("a=0:0.3:4").values, (Values{"0", "0.1", "0.2", "0.3"}));
    // Each value is the double nearest to the exact one, in its shortest form.
    EXPECT_EQ(parse_sweep("a=0:1:4").values,
              (Values{"0", "0.3333333333333333", "0.6666666666666666", "1"}));
    EXPECT_EQ(parse_sweep("a=4.155289061186346:4.155289061186346:2").values,
              (Values{"4.155289061186346", "4.155289061186346"}));
    EXPECT_EQ(parse_sweep("a=1:-1:3").values, (Values{"1", "0", "-1"}));
    EXPECT_EQ(parse_sweep("a=[1,2],[3,4]").values, (Values{"[1,2]", "[3,4]"}));
    EXPECT_EQ(parse_sweep("a=\"x,y\",z").values, (Values{"\"x,y\"", "z"}));
    for (const char* wrong : {"a", "=1", "a=", "a=1,,2", "a=0:1:1", "a=0:1:-3"})
        EXPECT_THROW(parse_sweep(wrong), InputError) << wrong;
    const auto points = points_of({"a=1,2", "b=x,y,z"});
    ASSERT_EQ(points.size(), 6u);
    EXPECT_EQ(in_words(points[1]), "a = 1, b = y");
    EXPECT_EQ(in_words(points[3]), "a = 2, b = x");
    EXPECT_THROW(points_of({"a=1,2", "a=3,4"}), InputError);
    EXPECT_THROW(points_of({"a=0:1:1000", "b=0:1:1000"}), InputError);
}

TEST(Sweep, CaptionsAreFormulasWithUnits) {
    const std::pair<SweepPoint, const char*> captions[] = {
        {{{"start.omega_rad_s[1]", "0.057"}}, "$\\omega_2 = 0.057$~rad/s"},
        {{{"body.moments_kg_m2[0]", "3"}}, "$I_1 = 3$~kg~m²"},
        {{{"start.theta_dot_rad_s", "-1.5"}}, "$\\dot{\\theta} = -1.5$~rad/s"},
        {{{"start.omega_rad_s[0]", "1"}, {"start.omega_rad_s[2]", "2"}},
         "$\\omega_1 = 1$~rad/s, $\\omega_3 = 2$~rad/s"},
        // Without a symbol or a number: as they are.
        {{{"film.fps", "30"}}, "fps = 30"},
        {{{"theme", "dark"}}, "theme = dark"},
        {{{"camera.azimuth_deg", "30"}}, "azimuth\\_deg = 30"},
        {{{"start.omega_rad_s", "[1,2,3]"}}, "omega\\_rad\\_s = [1,2,3]"}};
    for (const auto& [point, caption] : captions) EXPECT_EQ(formula_of(point), caption);
}

class Swept : public ::testing::Test {
 protected:
    Swept() { folder_.write("a.toml", a_scene); }
    Image image(const std::string& name) { return read_png(folder_.path() / name); }
    ProgramRun run(const std::string& arguments) { return run_program_in(folder_, arguments); }

    ScratchFolder folder_;
};

TEST_F(Swept, EqualsEachValueSetAlone) {
    const std::string key = "start.omega_rad_s[1]";
    ASSERT_EQ(
        run("still a.toml -q -o '{scene}_{" + key + "}.png' --sweep '" + key + "=1:2:3'").code, 0);
    ASSERT_EQ(run("still a.toml -q -o '##.png' --sweep '" + key + "=1,1.5,2'").code, 0);
    ASSERT_EQ(run("still a.toml -q -o 'k{key}.png' --sweep '" + key + "=1,1.5,2'").code, 0);
    int number = 0;
    for (const std::string value : {"1", "1.5", "2"}) {
        ASSERT_EQ(run("still a.toml -q -o one.png --set '" + key + "=" + value + "'").code, 0);
        const std::string right = text_of(folder_.path() / "one.png");
        EXPECT_EQ(text_of(folder_.path() / ("a_" + value + ".png")), right);
        EXPECT_EQ(text_of(folder_.path() / ("k" + value + ".png")), right);
        EXPECT_EQ(text_of(folder_.path() / ("0" + std::to_string(number++) + ".png")), right);
        // Only this item is set; the others keep the scene's values.
        ASSERT_EQ(
            run("still a.toml -q -o all.png --set 'start.omega_rad_s=[0.3, " + value + ", 0.1]'")
                .code,
            0);
        EXPECT_TRUE(image("all.png") == image("one.png"));
    }
    EXPECT_FALSE(image("00.png") == image("01.png"));
}

TEST_F(Swept, MakesFilmsOfAProduct) {
    const ProgramRun done =
        run("render a.toml -q -o '{film.fps}_{theme}.md5' --sweep film.fps=30,60 --sweep "
            "theme=light,dark");
    ASSERT_EQ(done.code, 0) << done.err;
    const auto n_lines = [&](const char* name) {
        const std::string text = text_of(folder_.path() / name);
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_EQ(n_lines("30_light.md5"), 3);
    EXPECT_EQ(n_lines("60_dark.md5"), 6);
    EXPECT_NE(text_of(folder_.path() / "60_dark.md5"), text_of(folder_.path() / "60_light.md5"));
}

TEST_F(Swept, IsCheckedValueByValue) {
    const ProgramRun words = run("check a.toml -q --sweep 'start.omega_rad_s[0]=0.3,0.6'");
    EXPECT_EQ(words.code, 0) << words.err;
    EXPECT_NE(words.out.find("start.omega_rad_s[0] = 0.3:\n"), std::string::npos) << words.out;
    EXPECT_NE(words.out.find("\n\nstart.omega_rad_s[0] = 0.6:\n"), std::string::npos) << words.out;
}

// JSON's punctuation outside strings, to count complete documents: "[{:,:},{}]".
std::string skeleton(const std::string& json) {
    std::string punctuation;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        if (in_string && json[i] == '\\')
            ++i;
        else if (json[i] == '"')
            in_string = !in_string;
        else if (!in_string && std::string("[]{}").find(json[i]) != std::string::npos)
            punctuation += json[i];
    }
    return in_string ? "a string without an end" : punctuation;
}

// Whether all brackets close, the last one at the end of the text.
bool is_one_document(const std::string& json) {
    const std::string punctuation = skeleton(json);
    int depth = 0;
    for (std::size_t i = 0; i < punctuation.size(); ++i) {
        depth += punctuation[i] == '[' || punctuation[i] == '{' ? 1 : -1;
        if (depth == 0) return i + 1 == punctuation.size();
    }
    return false;
}

TEST_F(Swept, IsOneJsonDocumentWhateverIsRefused) {
    const std::string sweep = "check a.toml -q --json --sweep 'start.omega_rad_s[0]=0.3,";
    const ProgramRun json = run(sweep + "0.6'");
    EXPECT_EQ(json.code, 0) << json.err;
    EXPECT_TRUE(json.out.starts_with("[\n")) << json.out;
    EXPECT_TRUE(is_one_document(json.out)) << json.out;
    EXPECT_NE(json.out.find("\"start.omega_rad_s[0]\": \"0.6\""), std::string::npos) << json.out;
    // A refused value, first, last or in the middle, does not affect the others.
    const ProgramRun partly = run(sweep + "none,0.6,1e400'");
    EXPECT_EQ(partly.code, 2);
    EXPECT_TRUE(is_one_document(partly.out)) << partly.out;
    EXPECT_EQ(std::count(partly.err.begin(), partly.err.end(), '\n'), 2) << partly.err;
    std::vector<std::string> lines;
    std::istringstream text(partly.out);
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 6u) << partly.out;
    const char* values[] = {"0.3", "none", "0.6", "1e400"};
    for (std::size_t k = 0; k < 4; ++k) {
        const std::string& line = lines[k + 1];
        EXPECT_NE(line.find(std::string("[0]\": \"") + values[k] + "\""), std::string::npos)
            << line;
        EXPECT_EQ(line.find("\"error\": ") != std::string::npos, k % 2 == 1) << line;
    }
    EXPECT_TRUE(is_one_document(run("check a.toml -q --json").out));
    const ProgramRun refused = run("check a.toml -q --json --set fps=0");
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.out, "");
    // Every list is available in JSON; a manual page is not.
    const ProgramRun lists = run("list --json");
    EXPECT_TRUE(is_one_document(lists.out)) << lists.out;
    EXPECT_NE(lists.out.find("\"schema\""), std::string::npos) << lists.out;
    EXPECT_TRUE(is_one_document(run("list schema --json").out));
    EXPECT_EQ(run("list poinsot.1 --json").code, 2);
    EXPECT_FALSE(is_one_document("{}\n{}\n"));
    EXPECT_FALSE(is_one_document("[\n{}\n"));
}

// Ten moments, of which only the last three are possible: one message, with the swept key and its
// least value.
TEST_F(Swept, IsRefusedOnceForOneReason) {
    const ProgramRun done =
        run("still a.toml -q -o 'm_{key}.png' --sweep 'body.moments_kg_m2[2]=0.1:1.2:12'");
    EXPECT_EQ(done.code, 2);
    EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 2) << done.err;
    EXPECT_EQ(done.err.rfind("--sweep body.moments_kg_m2[2]=0.1: ", 0), 0u) << done.err;
    EXPECT_NE(done.err.find("make I1 at most 2.1, I2 at least 2.9 or I3 at least 1, or set"),
              std::string::npos)
        << done.err;
    EXPECT_NE(done.err.find("refused for the same reason: body.moments_kg_m2[2]=0.2; "),
              std::string::npos)
        << done.err;
    EXPECT_NE(done.err.find("=0.6; and 3 more\n"), std::string::npos) << done.err;
    EXPECT_TRUE(fs::exists(folder_.path() / "m_1.2.png"));
    EXPECT_FALSE(fs::exists(folder_.path() / "m_0.9.png"));
    // Different reasons are reported separately.
    const ProgramRun two = run("still a.toml -q -o 'n_{key}.png' --sweep film.fps=x,0,-1,30");
    EXPECT_EQ(two.code, 2);
    EXPECT_GE(std::count(two.err.begin(), two.err.end(), '\n'), 2) << two.err;
}

TEST_F(Swept, IsRefusedInASentence) {
    const auto expect = [&](const std::string& arguments, const std::string& words) {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.code, 2) << arguments;
        EXPECT_NE(done.err.find(words), std::string::npos) << done.err;
        EXPECT_EQ(std::count(done.err.begin(), done.err.end(), '\n'), 1) << done.err;
    };
    expect("still a.toml -o one.png --sweep film.fps=30,60",
           "film.fps=30 and film.fps=60 would both be written to one.png");
    expect("still a.toml -o '{theme}.png' --sweep theme=light,dark --sweep film.fps=30,60",
           "film.fps=30 and film.fps=60 would both be written to light.png");
    expect("still a.toml -o one.png --sweep theme=light,dark", "theme=light and theme=dark would");
    expect("still a.toml a.toml", "a.toml is given twice");
    expect("still a.toml -o '##.png' --sweep 'start.omega_rad_s[3]=1'",
           "there is no omega_rad_s[3]");
    expect("still a.toml -o '##.png' --sweep 'film.duration_s[0]=1'", "there is no duration_s[0]");
    expect("still a.toml -o s.png --sheet 2x1 --sweep film.fps=10,20,30",
           "2 places for 3 pictures");
    expect("still a.toml -o s.png --sheet 2 --sweep film.fps=10,20", "write CxR");
    expect("still a.toml -o s.gif --sheet 2x1 --sweep film.fps=10,20", "a sheet is a PNG");
    for (const std::string option : {"--depth 16", "--shading none", "--text paths"})
        expect("still a.toml -o s.png --sheet 2x1 --sweep film.fps=10,20 " + option,
               "leave " + option.substr(0, option.find(' ')) + " out");
    EXPECT_FALSE(fs::exists(folder_.path() / "one.png"));
}

// Each picture of a sheet equals the single picture, with a caption below it.
TEST_F(Swept, IsArrangedInASheet) {
    // A key that changes pictures, but not their view.
    const std::string sweep = "--time auto --sweep 'hidden=pale,dashed,omitted'";
    const ProgramRun done = run("still a.toml -q -o sheet.png --sheet 2x2 " + sweep);
    ASSERT_EQ(done.code, 0) << done.err;
    ASSERT_EQ(run("still a.toml -q -o '#.png' --set overlays=false " + sweep).code, 0);
    const Image sheet = image("sheet.png");
    ASSERT_EQ(sheet.width(), 2 * 192);
    const int row = sheet.height() / 2;
    ASSERT_GT(row, 108);
    for (int k = 0; k < 3; ++k) {
        const Image one = image(std::to_string(k) + ".png");
        bool same = true, written = false;
        for (int x = 0; x < 192; ++x) {
            for (int y = 0; y < row; ++y) {
                const Rgba8 there = sheet.at(192 * (k % 2) + x, row * (k / 2) + y);
                if (y < 108)
                    same = same && there == one.at(x, y);
                else
                    written = written || !(there == one.at(0, 0));
            }
        }
        EXPECT_TRUE(same) << k;
        EXPECT_TRUE(written) << k;
    }
    for (int x = 192; x < 384; ++x) EXPECT_TRUE(sheet.at(x, row + 50) == sheet.at(0, 0));
}

// The view of a cell depends on all cells, not on their order, so that sizes can be compared.
TEST_F(Swept, CellsOfASheetHaveOneView) {
    const auto sheet_of = [this](const std::string& values) {
        const ProgramRun done =
            run("still a.toml -q -o sheet.png --sheet 2x1 --time 0 --sweep 'start.omega_rad_s[1]=" +
                values + "'");
        EXPECT_EQ(done.code, 0) << done.err;
        return image("sheet.png");
    };
    const Image both = sheet_of("0.3,3"), reversed = sheet_of("3,0.3"), twice = sheet_of("3,3");
    bool same = true, as_alone = true;
    for (int x = 0; x < 192; ++x)
        for (int y = 0; y < 108; ++y) {
            same = same && both.at(x, y) == reversed.at(192 + x, y) &&
                   both.at(192 + x, y) == reversed.at(x, y);
            as_alone = as_alone && both.at(192 + x, y) == twice.at(x, y);
        }
    EXPECT_TRUE(same);
    EXPECT_FALSE(as_alone);
}

// So that its pictures can be compared.
TEST_F(Swept, SheetShowsTheFilmsLastInstantByDefault) {
    const auto sheet_at = [this](const std::string& time) {
        const ProgramRun done = run("still a.toml -q -o sheet.png --sheet 2x1 " + time +
                                    " --sweep 'start.omega_rad_s[1]=1,2'");
        EXPECT_EQ(done.code, 0) << done.err;
        return image("sheet.png");
    };
    const Image sheet = sheet_at(""), last = sheet_at("--time 0.06666666666666667"),
                clearest = sheet_at("--time auto");
    EXPECT_TRUE(std::ranges::equal(sheet.bytes(), last.bytes()));
    EXPECT_FALSE(std::ranges::equal(sheet.bytes(), clearest.bytes()));
}

// One table with the values in each row, or a file for each value.
TEST_F(Swept, IsSampledValueByValue) {
    const std::string key = "start.omega_rad_s[1]";
    const std::string what = "sample a.toml --times 0,1 --columns omega_body ";
    std::string right = key + ",omega_body_1_rad_s,omega_body_2_rad_s,omega_body_3_rad_s\n";
    for (const std::string value : {"1", "1.5"}) {
        const ProgramRun one = run(what + "--set '" + key + "=" + value + "'");
        ASSERT_EQ(one.code, 0) << one.err;
        std::istringstream lines(one.out);
        std::string line;
        std::getline(lines, line);
        while (std::getline(lines, line)) right += value + "," + line + "\n";
        ASSERT_EQ(run(what + "--set '" + key + "=" + value + "' -o one.csv").code, 0);
        ASSERT_EQ(run(what + "--sweep '" + key + "=1,1.5' -o '{scene}_{key}.csv'").code, 0);
        EXPECT_EQ(text_of(folder_.path() / ("a_" + value + ".csv")),
                  text_of(folder_.path() / "one.csv"));
    }
    const ProgramRun all = run(what + "--sweep '" + key + "=1,1.5'");
    EXPECT_EQ(all.out, right);
    ASSERT_EQ(run(what + "--sweep '" + key + "=1,1.5' -o all.csv").code, 0);
    EXPECT_EQ(text_of(folder_.path() / "all.csv"), right);
    const ProgramRun words = run(what + "--sweep theme=light,dark");
    EXPECT_EQ(words.code, 2);
    EXPECT_NE(words.err.find("light is not a number"), std::string::npos) << words.err;
    EXPECT_EQ(words.out, "");
}

// A sheet has a record, which states that the sheet cannot be rendered again from it.
TEST_F(Swept, SheetCarriesARecord) {
    ASSERT_EQ(run("still a.toml -q -o sheet.png --sheet 2x1 --sweep film.fps=10,20").code, 0);
    const ProgramRun said = run("explain --verify sheet.png");
    EXPECT_EQ(said.code, 1) << said.err;
    EXPECT_NE(said.err.find("unchanged, record and pictures; it cannot be drawn again"),
              std::string::npos)
        << said.err;
    EXPECT_NE(said.out.find("\nsheet: 2x1: fps = 10; fps = 20\n"), std::string::npos) << said.out;
    const ProgramRun again = run("rerender sheet.png -o again.png");
    EXPECT_EQ(again.code, 2);
    EXPECT_NE(again.err.find("is a sheet of several pictures"), std::string::npos) << again.err;
}

}  // namespace
}  // namespace poinsot::testing::sweep_tests
