// The output of sample: columns by name, and three formats.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program_run.h"
#include "production/session/session.h"
#include "scene/files/load_scene.h"

namespace poinsot {
namespace {

using testing::ProgramRun;
using testing::run_program_in;
using testing::ScratchFolder;
using testing::text_of;

constexpr const char* racket = R"([body]
moments_kg_m2 = [3.0, 2.0, 1.0]
[start]
omega_rad_s = [0.01, 2.0, 0.01]
)";

constexpr const char* tilted = R"([body]
tensor_kg_m2 = [[3.0, 0.2, 0.1], [0.2, 2.5, -0.3], [0.1, -0.3, 2.0]]
[start]
omega_rad_s = [0.4, 1.1, -0.7]
)";

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::stringstream stream(text);
    for (std::string part; std::getline(stream, part, at);) parts.push_back(part);
    return parts;
}

// The rows of a CSV without its heading.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    const std::vector<std::string> lines = split(csv, '\n');
    for (std::size_t i = 1; i < lines.size(); ++i) {
        rows.emplace_back();
        for (const std::string& item : split(lines[i], ',')) rows.back().push_back(std::stod(item));
    }
    return rows;
}

// T, L, ρ and the rotation are computed again from the plain columns, by other formulas.
TEST(SampleColumns, AgreeWithThePlainColumns) {
    const ScratchFolder folder;
    folder.write("scene.toml", tilted);
    const ProgramRun run = run_program_in(
        folder,
        "sample scene.toml --times 0:20/41 --columns "
        "omega_body,q,omega_space,kinetic_energy,momentum,momentum_space,contact_space,euler");
    ASSERT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(split(run.out, '\n')[0],
              "omega_body_1_rad_s,omega_body_2_rad_s,omega_body_3_rad_s,q_w,q_x,q_y,q_z,"
              "omega_space_x_rad_s,omega_space_y_rad_s,omega_space_z_rad_s,kinetic_energy_J,"
              "momentum_kg_m2_s,momentum_space_x_kg_m2_s,momentum_space_y_kg_m2_s,"
              "momentum_space_z_kg_m2_s,contact_space_x_per_sqrt_kg_m2,"
              "contact_space_y_per_sqrt_kg_m2,contact_space_z_per_sqrt_kg_m2,theta_rad,phi_rad,"
              "psi_rad");
    const double J[3][3] = {{3.0, 0.2, 0.1}, {0.2, 2.5, -0.3}, {0.1, -0.3, 2.0}};
    const auto rows = rows_of(run.out);
    ASSERT_EQ(rows.size(), 41u);
    for (const auto& v : rows) {
        const double w = v[3];
        const double x = v[4];
        const double y = v[5];
        const double z = v[6];
        const double R[3][3] = {
            {1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
        double twice_T = 0.0;
        double L[3] = {0, 0, 0};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                L[i] += J[i][j] * v[static_cast<std::size_t>(j)];
                twice_T +=
                    v[static_cast<std::size_t>(i)] * J[i][j] * v[static_cast<std::size_t>(j)];
            }
        EXPECT_NEAR(v[10], 0.5 * twice_T, 1e-14 * twice_T);
        EXPECT_NEAR(v[11], std::hypot(L[0], L[1], L[2]), 1e-14 * v[11]);
        for (std::size_t i = 0; i < 3; ++i) {
            double omega = 0.0;
            double momentum = 0.0;
            for (std::size_t j = 0; j < 3; ++j) {
                omega += R[i][j] * v[j];
                momentum += R[i][j] * L[j];
            }
            EXPECT_NEAR(v[7 + i], omega, 5e-15);
            EXPECT_NEAR(v[12 + i], momentum, 2e-14);
            EXPECT_NEAR(v[15 + i], omega / std::sqrt(twice_T), 5e-15);
        }
        // R = Rz(φ) Rx(θ) Rz(ψ): its last column and row contain θ, φ and ψ.
        EXPECT_NEAR(std::cos(v[18]), R[2][2], 5e-15);
        EXPECT_NEAR(std::sin(v[18]) * std::sin(v[19]), R[0][2], 5e-15);
        EXPECT_NEAR(std::sin(v[18]) * std::sin(v[20]), R[2][0], 5e-15);
    }
    // L is constant, and every residual is a rounding error.
    for (std::size_t i = 12; i < 15; ++i) EXPECT_NEAR(rows.back()[i], rows.front()[i], 1e-13);
    const auto residuals = rows_of(
        run_program_in(folder, "sample scene.toml --times 0:20/41 --columns residuals").out);
    ASSERT_EQ(residuals.size(), 41u);
    for (const auto& row : residuals) {
        ASSERT_EQ(row.size(), 6u);
        for (const double residual : row) EXPECT_LT(residual, 2e-14);
    }
}

TEST(SampleColumns, OneColumnIsNamedWithOrWithoutItsUnit) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string run = "sample scene.toml --times 0:1:0.5 --columns ";
    EXPECT_EQ(run_program_in(folder, run + "time,omega_body_2").out,
              run_program_in(folder, run + "time_s,omega_body_2_rad_s").out);
    EXPECT_TRUE(run_program_in(folder, run + "omega_body_2,time")
                    .out.starts_with("omega_body_2_rad_s,time_s\n2,0\n"));
}

TEST(SampleColumns, MayBeNamedByTheLecturesSymbols) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const std::string run = "sample scene.toml --times 0:1:0.5 --columns ";
    const std::string by_symbol = run_program_in(folder, run + "T,L,t,rho").out;
    EXPECT_TRUE(by_symbol.starts_with("kinetic_energy_J,momentum_kg_m2_s,time_s,")) << by_symbol;
    EXPECT_EQ(by_symbol,
              run_program_in(folder, run + "kinetic_energy,momentum,time,contact_body").out);
}

TEST(SampleColumns, UnknownDuplicateOrMissingColumnsAreRefused) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    folder.write("driven.toml", std::string(racket) + "[torque]\nkind = \"constant-space\"\n");
    const std::string run = "sample scene.toml --times 0 --columns ";
    const auto said = [&](const std::string& names, const std::string& what) {
        const ProgramRun answer = run_program_in(folder, run + names);
        EXPECT_EQ(answer.code, 2);
        EXPECT_NE(answer.err.find(what), std::string::npos) << answer.err;
        EXPECT_EQ(answer.out, "");
    };
    said("omega_bdy", "did you mean \"omega_body\"");
    said("omega_body,omega_body_1", "given twice");
    said("time,", "no column is called \"\"");
}

TEST(SampleFiles, AllFormatsContainTheSameNumbers) {
    const ScratchFolder folder;
    folder.write("scene.toml", tilted);
    const std::string run = "sample scene.toml --times=-3:1e6/77";
    const ProgramRun printed = run_program_in(folder, run);
    ASSERT_EQ(printed.code, 0) << printed.err;
    for (const char* file : {"a.csv", "a.jsonl", "a.npy", "B.NPY"})
        ASSERT_EQ(run_program_in(folder, run + " -o " + file).code, 0) << file;
    EXPECT_EQ(text_of(folder.path() / "a.csv"), printed.out);

    // Every line of JSON contains the names and decimals of the CSV.
    const std::vector<std::string> csv = split(printed.out, '\n');
    const std::vector<std::string> json = split(text_of(folder.path() / "a.jsonl"), '\n');
    const std::vector<std::string> names = split(csv[0], ',');
    ASSERT_EQ(json.size() + 1, csv.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::vector<std::string> numbers = split(csv[i + 1], ',');
        std::string line = "{";
        for (std::size_t k = 0; k < names.size(); ++k)
            line += (k > 0 ? ",\"" : "\"") + names[k] + "\":" + numbers[k];
        EXPECT_EQ(json[i], line + "}");
    }

    // numpy.lib.format: magic, version 1.0, a header of little-endian length, then the numbers.
    const std::string npy = text_of(folder.path() / "a.npy");
    EXPECT_EQ(npy, text_of(folder.path() / "B.NPY"));
    ASSERT_TRUE(npy.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
    const std::size_t length =
        static_cast<unsigned char>(npy[8]) + std::size_t{256} * static_cast<unsigned char>(npy[9]);
    EXPECT_EQ((10 + length) % 64, 0u);
    const std::string header = npy.substr(10, length);
    EXPECT_TRUE(header.starts_with("{'descr': [('time_s', '<f8'), ('omega_body_1', '<f8'), "))
        << header;
    EXPECT_NE(header.find("'fortran_order': False, 'shape': (77,), }"), std::string::npos);
    EXPECT_EQ(header.back(), '\n');
    const auto rows = rows_of(printed.out);
    ASSERT_EQ(npy.size(), 10 + length + 77 * names.size() * sizeof(double));
    std::vector<double> stored(77 * names.size());
    std::memcpy(stored.data(), npy.data() + 10 + length, stored.size() * sizeof(double));
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < names.size(); ++k)
            EXPECT_EQ(stored[i * names.size() + k], rows[i][k]);
}

// Keyframes that three.js reads: the same attitudes, x, y, z, w, never far from the one before.
TEST(SampleFiles, KeyframesAreTheAttitudesWithoutJumps) {
    const ScratchFolder folder;
    folder.write("scene.toml", tilted);
    const std::string run = "sample scene.toml --times 0:60:0.05";
    const auto rows = rows_of(run_program_in(folder, run).out);
    ASSERT_EQ(run_program_in(folder, run + " -o motion.json").code, 0);
    const auto clip = nlohmann::json::parse(text_of(folder.path() / "motion.json"));
    const auto& track = clip.at("tracks").at(0);
    EXPECT_EQ(clip.at("duration"), 60.0);
    EXPECT_EQ(track.at("name"), ".quaternion");
    EXPECT_EQ(track.at("type"), "quaternion");
    const auto times = track.at("times").get<std::vector<double>>();
    const auto values = track.at("values").get<std::vector<double>>();
    ASSERT_EQ(times.size(), rows.size());
    ASSERT_EQ(values.size(), 4 * rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(times[i], rows[i][0]);
        const Eigen::Vector4d key(values[4 * i], values[4 * i + 1], values[4 * i + 2],
                                  values[4 * i + 3]);
        const Eigen::Vector4d attitude(rows[i][5], rows[i][6], rows[i][7], rows[i][4]);
        EXPECT_EQ(key, attitude) << i;
        if (i > 0) {
            const Eigen::Vector4d before(values[4 * i - 4], values[4 * i - 3], values[4 * i - 2],
                                         values[4 * i - 1]);
            EXPECT_LT((key - before).norm(), 0.05) << i;
        }
    }
    const ProgramRun columns = run_program_in(folder, run + " --columns time,T -o a.json");
    EXPECT_EQ(columns.code, 2);
    EXPECT_NE(columns.err.find("keyframes, which need q_x"), std::string::npos) << columns.err;
    const ProgramRun unsorted = run_program_in(folder, "sample scene.toml --times 1,0 -o a.json");
    EXPECT_EQ(unsorted.code, 2);
    EXPECT_NE(unsorted.err.find("in order of time"), std::string::npos) << unsorted.err;
}

// tests/outputs/production computes the construction in the pixels from these numbers.
TEST(SampleFiles, OmegaAndAttitudeAreExactlyThoseOfTheMotion) {
    const ScratchFolder folder;
    folder.write("scene.toml", tilted);
    const auto rows = rows_of(run_program_in(folder, "sample scene.toml --times 0.3,3.7,90").out);
    ASSERT_EQ(rows.size(), 3u);
    SessionRequest request;
    request.times_s = {90.0};
    const Session session = session_of(parse_scene(tilted, "scene.toml"), request);
    for (const std::vector<double>& row : rows) {
        const RotationState state = session.motion.at(row.at(0));
        const Eigen::Quaterniond& q = state.space_from_body;
        const std::vector<double> expected{row[0],
                                           state.omega_body.x(),
                                           state.omega_body.y(),
                                           state.omega_body.z(),
                                           q.w(),
                                           q.x(),
                                           q.y(),
                                           q.z()};
        EXPECT_EQ(std::vector<double>(row.begin(), row.begin() + 8), expected);
    }
}

TEST(SampleFiles, AnotherSuffixOrAnErrorLeavesNoFile) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun suffix = run_program_in(folder, "sample scene.toml --times 0 -o a.xlsx");
    EXPECT_EQ(suffix.code, 2);
    EXPECT_NE(suffix.err.find(".csv, .jsonl, .json, .npy"), std::string::npos) << suffix.err;
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times 0,1e308 -o a.csv").code, 2);
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times 0 -o no/a.csv").code, 3);
    EXPECT_EQ(run_program_in(folder, "sample scene.toml --times 0:1:1e-9 -o a.csv").code, 2);
    EXPECT_EQ(folder.listing(), "scene.toml\n");
}

#ifdef NDEBUG
// Processor time in user mode, of this process or of the programs that it has run.
double user_s(int whose) {
    rusage usage{};
    getrusage(whose, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

TEST(SampleFiles, AMillionInstantsAsTextCostLessThanPrintfAndAsArrayAThird) {
    // The time of the C library to print a million doubles in full; a row has eleven.
    const double idle_s = user_s(RUSAGE_SELF);
    std::array<char, 32> digits{};
    for (int k = 1; k <= 1'000'000; ++k)
        ASSERT_GT(std::snprintf(digits.data(), digits.size(), "%.17g", std::sqrt(k)), 0);
    const double printed_s = 11.0 * (user_s(RUSAGE_SELF) - idle_s);

    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const double start_s = user_s(RUSAGE_CHILDREN);
    ASSERT_EQ(run_program_in(folder, "sample scene.toml --times 0:1000/1000000 -o a.npy").code, 0);
    const double array_s = user_s(RUSAGE_CHILDREN) - start_s;
    ASSERT_EQ(run_program_in(folder, "sample scene.toml --times 0:1000/1000000 -o a.csv").code, 0);
    const double text_s = user_s(RUSAGE_CHILDREN) - start_s - array_s;
    EXPECT_LT(array_s, printed_s / 3.0);
    EXPECT_LT(text_s, printed_s);
    RecordProperty("array_over_printed", std::to_string(array_s / printed_s));
    RecordProperty("text_over_printed", std::to_string(text_s / printed_s));
}
#endif

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::stringstream stream(line);
    for (std::string item; std::getline(stream, item, ',');) numbers.push_back(std::stod(item));
    return numbers;
}

TEST(Sample, PrintsTheFixedColumnsAndExactDoubles) {
    const ScratchFolder folder;
    folder.write("scene.toml", racket);
    const ProgramRun run = run_program_in(folder, "sample scene.toml --times 0,0.1");
    ASSERT_EQ(run.code, 0) << run.err;
    std::stringstream lines(run.out);
    std::string header;
    std::string first;
    std::string second;
    std::getline(lines, header);
    std::getline(lines, first);
    std::getline(lines, second);
    EXPECT_EQ(header,
              "time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,"
              "herpolhode_x,herpolhode_y,herpolhode_z");
    const auto at_0 = numbers_of(first);
    ASSERT_EQ(at_0.size(), 11u);
    // The start is printed exactly.
    const std::vector<double> start(at_0.begin(), at_0.begin() + 8);
    EXPECT_EQ(start, (std::vector<double>{0.0, 0.01, 2.0, 0.01, 1.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(numbers_of(second)[0], 0.1);
}

// A motion may be within the range of double, and its energy beyond it.
TEST(Sample, WritesNoTableWithANumberThatIsNotFinite) {
    const ScratchFolder folder;
    folder.write("top.toml",
                 "[body]\nmoments_kg_m2 = [1.9, 1.9, 0.339]\n[start]\ntheta_rad = 0.5\n"
                 "omega3_rad_s = 1e308\n[torque]\nkind = \"gravity\"\nmgl_N_m = 1.0\n");
    const ProgramRun start = run_program_in(folder, "sample top.toml --times 0");
    EXPECT_EQ(start.code, 0) << start.err;
    EXPECT_NE(start.out.find("\n0,0,0,1e+308,"), std::string::npos) << start.out;
    EXPECT_EQ(start.out.find("nan"), std::string::npos) << start.out;
    for (const auto& [line, message] : std::vector<std::array<std::string, 2>>{
             {"--columns T", "--times 0: kinetic_energy lies beyond the range of double"},
             {"--set start.omega3_rad_s=1.7e308 --set 'body.moments_kg_m2=[1.9,1.9,3]'",
              "omega3_rad_s: the angular momentum of the top overflows; choose other units"},
             {"--set start.theta_dot_rad_s=1e308",
              "theta_dot_rad_s: the angular momentum of the top overflows; choose other units"}}) {
        const ProgramRun run = run_program_in(folder, "sample top.toml --times 0 " + line);
        EXPECT_EQ(run.code, 2) << line;
        EXPECT_EQ(run.out, "") << line;
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    }
}

}  // namespace
}  // namespace poinsot
