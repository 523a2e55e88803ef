#include "measured/measured_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "error/error.h"

namespace poinsot {

namespace {

// The message that this table is refused with. It begins with the error's place.
std::string refusal(const std::string& table) {
    try {
        read_measured(table, "gyro.csv");
    } catch (const InputError& error) {
        const InputPlace place = error.place().value_or(InputPlace{});
        EXPECT_TRUE(std::string_view(error.what())
                        .starts_with(place.file + ":" + std::to_string(place.line) + ":" +
                                     std::to_string(place.column) + ": "))
            << error.what();
        return error.what();
    }
    return "not refused";
}

void expect_refused(const std::string& table, const std::string& message) {
    EXPECT_TRUE(refusal(table).starts_with(message)) << refusal(table);
}

TEST(MeasuredReader, ReadsTablesOfTheProgramItself) {
    const MeasuredMotion motion = read_measured(
        "time_s,omega_body_1,omega_body_2,omega_body_3,q_w,q_x,q_y,q_z,herpolhode_x\n"
        "0,1.2,0.8,2.4,1,0,0,0,-0.6\n0.5,1.5,-0.5,2.5,0.6,0,0.8,0,0.1\n",
        "a.csv");
    ASSERT_EQ(motion.rows.size(), 2u);
    EXPECT_TRUE(motion.has_omega && motion.has_attitude);
    EXPECT_EQ(motion.rows[1].time_s, 0.5);
    EXPECT_EQ(motion.rows[1].omega_body, Eigen::Vector3d(1.5, -0.5, 2.5));
    EXPECT_NEAR(motion.rows[1].space_from_body.y(), 0.8, 1e-15);
}

TEST(MeasuredReader, ReadsExportsOfPhonesWithTheirUnits) {
    const MeasuredMotion motion = read_measured(
        "\xEF\xBB\xBF\"Time (ms)\";\"Gyroscope x (°/s)\";\"Gyroscope y (°/s)\";\"Gyroscope z "
        "(°/s)\";\"Absolute (°/s)\"\r\n"
        "10;180;-90;0;201\r\n\r\n20;1.8E+02;+90;1;201\r\n",
        "a.csv");
    ASSERT_EQ(motion.rows.size(), 2u);
    EXPECT_FALSE(motion.has_attitude);
    EXPECT_DOUBLE_EQ(motion.rows[1].time_s, 0.02);
    EXPECT_NEAR(motion.rows[1].omega_body.x(), std::numbers::pi, 1e-15);
    EXPECT_NEAR(motion.rows[1].omega_body.y(), 0.5 * std::numbers::pi, 1e-15);
}

TEST(MeasuredReader, ReadsDecimalCommasWhereTheyAreNoSeparators) {
    const std::string rows[] = {"\"0,01\";\"8,5E+00\";\"-1,25\";\"2\"\r\n",
                                "0,01\t8,5E+00\t-1,25\t2\n", "\"0,01\",\"8,5E+00\",\"-1,25\",2\n"};
    const char separators[] = {';', '\t', ','};
    for (std::size_t k = 0; k < 3; ++k) {
        std::string head = "Zeit (s);Gyroskop x (rad/s);Gyroskop y (rad/s);Gyroskop z (rad/s)\n";
        std::replace(head.begin(), head.end(), ';', separators[k]);
        const MeasuredMotion motion = read_measured("\xEF\xBB\xBF" + head + rows[k], "a.csv");
        ASSERT_EQ(motion.rows.size(), 1u);
        EXPECT_EQ(motion.rows[0].time_s, 0.01);
        EXPECT_EQ(motion.rows[0].omega_body, Eigen::Vector3d(8.5, -1.25, 2.0));
    }
}

TEST(MeasuredReader, IgnoresRowsWithoutAnyValue) {
    const MeasuredMotion motion =
        read_measured("t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n,,,\n,,,,\n\"\", ,,\n", "a.csv");
    EXPECT_EQ(motion.rows.size(), 2u);
}

TEST(MeasuredReader, TakesTheMostCertainColumns) {
    // Sensor Logger: nanoseconds since 1970, and seconds of the recording.
    MeasuredMotion motion = read_measured(
        "time,seconds_elapsed,z,y,x\n1635954023000000000,0.01,3,2,1\n1635954023010000000,0.02,6,5,"
        "4\n",
        "Gyroscope.csv");
    EXPECT_EQ(motion.rows[1].time_s, 0.02);
    EXPECT_EQ(motion.rows[1].omega_body, Eigen::Vector3d(4.0, 5.0, 6.0));
    // Physics Toolbox, and a place and an acceleration beside ω.
    motion = read_measured("time,gFx,gFy,gFz,ax,ay,az,wx,wy,wz,x,y,z\n0,9,9,9,9,9,9,1,2,3,9,9,9\n",
                           "a.csv");
    EXPECT_EQ(motion.rows[0].omega_body, Eigen::Vector3d(1.0, 2.0, 3.0));
    // Beside attitudes, x, y and z are a place.
    motion = read_measured("t,x,y,z,qw,qx,qy,qz\n0,9,9,9,1,0,0,0\n", "a.csv");
    EXPECT_FALSE(motion.has_omega);
    EXPECT_TRUE(motion.has_attitude);
}

TEST(MeasuredReader, RefusesColumnsOfOtherSensors) {
    EXPECT_TRUE(refusal("t,x (m/s^2),y (m/s^2),z (m/s^2)\n0,1,2,3\n")
                    .ends_with("; it has \"t\", \"x (m/s^2)\", \"y (m/s^2)\", \"z (m/s^2)\""));
    try {
        read_measured("time,seconds_elapsed,z,y,x\n0,0,1,2,3\n", "throw/Accelerometer.csv");
        ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "throw/Accelerometer.csv:1:22: by the table's name this is no column of ω; give "
                  "the gyroscope's table");
    }
    expect_refused(std::string("PK\x03\x04\0\0", 6), "gyro.csv:1:1: the file is a spreadsheet");
    expect_refused(std::string("\xD0\xCF\x11\xE0\xA1\0", 6),
                   "gyro.csv:1:1: the file is a spreadsheet");
}

TEST(MeasuredReader, ReadsMatrices) {
    const MeasuredMotion motion = read_measured(
        "t\tr11\tr12\tr13\tr21\tr22\tr23\tr31\tr32\tr33\n1\t0\t-1\t0\t1\t0\t0\t0\t0\t1\n", "a.tsv");
    EXPECT_FALSE(motion.has_omega);
    const Eigen::Vector3d turned = motion.rows[0].space_from_body * Eigen::Vector3d::UnitX();
    EXPECT_NEAR((turned - Eigen::Vector3d::UnitY()).norm(), 0.0, 1e-15);
}

// A turn about a fixed axis by sin t: ω = cos t, and differences over 2 h are cos t · sin h / h.
TEST(MeasuredMotion, GetsOmegaFromAttitudes) {
    MeasuredMotion motion;
    motion.has_attitude = true;
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
    const double step = 0.01;
    for (int i = 0; i <= 300; ++i) {
        MeasuredRow row;
        row.time_s = step * i;
        row.space_from_body = Eigen::AngleAxisd(std::sin(row.time_s), axis);
        if (i % 7 == 0) row.space_from_body.coeffs() *= -1.0;  // the same rotation
        motion.rows.push_back(row);
    }
    add_omega_by_differences(motion);
    for (std::size_t i = 1; i + 1 < motion.rows.size(); ++i) {
        const double omega = std::cos(motion.rows[i].time_s) * std::sin(step) / step;
        EXPECT_LT((motion.rows[i].omega_body - omega * axis).norm(), 1e-12) << i;
    }
    // At the ends over one step only.
    EXPECT_LT((motion.rows[0].omega_body - axis).norm(), step);
    // A table with ω keeps it.
    motion.has_omega = true;
    motion.rows[5].omega_body = {1.0, 2.0, 3.0};
    add_omega_by_differences(motion);
    EXPECT_EQ(motion.rows[5].omega_body, Eigen::Vector3d(1.0, 2.0, 3.0));
}

// ω = 1 rad/s about z, which was 3 rad/s in a gap.
TEST(MeasuredMotion, GetsOmegaOnEachSideOfAGap) {
    MeasuredMotion motion;
    motion.has_attitude = true;
    for (int i = 0; i < 20; ++i) {
        MeasuredRow row;
        row.time_s = 0.1 * i + (i < 10 ? 0.0 : 1.0);
        const double angle = 0.1 * i + (i < 10 ? 0.0 : 3.0);
        row.space_from_body = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ());
        motion.rows.push_back(row);
    }
    add_omega_by_differences(motion);
    for (const MeasuredRow& row : motion.rows)
        EXPECT_LT((row.omega_body - Eigen::Vector3d::UnitZ()).norm(), 1e-12) << row.time_s;
}

// A single row before the first gap, or after the last one, has a neighbour only across the gap.
TEST(MeasuredMotion, GetsOmegaOfLoneRowsAcrossTheGap) {
    MeasuredMotion motion;
    motion.has_attitude = true;
    for (const double time_s : {0.0, 5.0, 5.1, 5.2, 5.3, 10.0}) {
        MeasuredRow row;
        row.time_s = time_s;
        row.space_from_body = Eigen::AngleAxisd(0.1 * time_s, Eigen::Vector3d::UnitZ());
        motion.rows.push_back(row);
    }
    add_omega_by_differences(motion);
    for (const MeasuredRow& row : motion.rows)
        EXPECT_LT((row.omega_body - 0.1 * Eigen::Vector3d::UnitZ()).norm(), 1e-12) << row.time_s;
}

TEST(MeasuredReader, TakesPiecesCutAnywhere) {
    const std::string table = "t,wx,wy,wz\n0,1,2,3\n1,4,5,6\n2,7,8,9";
    for (std::size_t cut = 0; cut <= table.size(); ++cut) {
        double sum = 0.0;
        MeasuredReader reader("a.csv",
                              [&sum](const MeasuredRow& row) { sum += row.omega_body.sum(); });
        reader.read(std::string_view(table).substr(0, cut));
        reader.read(std::string_view(table).substr(cut));
        reader.finish();
        EXPECT_EQ(sum, 45.0) << cut;
    }
}

TEST(MeasuredReader, RefusesWithLineAndColumn) {
    const std::string head = "t,wx,wy,wz\n";
    expect_refused("", "gyro.csv:1:1: the file is empty");
    expect_refused(head, "gyro.csv:2:1: the table has no rows");
    expect_refused("wx,wy,wz\n1,2,3\n",
                   "gyro.csv:1:1: the first line names no column for the time");
    expect_refused("t,wx,wy\n",
                   "gyro.csv:1:1: the first line names no column for each component of ω");
    expect_refused("t,a,b\n0,1,2\n",
                   "gyro.csv:1:1: the first line names no column for ω or the attitude");
    expect_refused("t,wx,wy,omega_x,wz\n",
                   "gyro.csv:1:9: two columns say the same, \"wx\" and \"omega_x\"");
    expect_refused("t (kg),wx,wy,wz\n", "gyro.csv:1:1: \"kg\" is no unit of time");
    expect_refused("t,wx (m/s),wy,wz\n", "gyro.csv:1:3: \"m/s\" is no unit of angular velocity");
    expect_refused(head + "0,1,2,3\n0,1,2,3\n",
                   "gyro.csv:3:1: the time 0 s does not come after 0 s");
    expect_refused(head + "1,1,2,3\n0,1,2,3\n",
                   "gyro.csv:3:1: the time 0 s does not come after 1 s");
    expect_refused(head + "0,1,nan,3\n", "gyro.csv:2:5: \"nan\" is not a");
    expect_refused(head + "0,1,inf,3\n", "gyro.csv:2:5: \"inf\" is not a");
    expect_refused(head + "0,1e999,2,3\n", "gyro.csv:2:3: \"1e999\" is not a");
    expect_refused(head + "0,1,,3\n", "gyro.csv:2:5: the cell is empty");
    expect_refused(head + "0,1,two,3\n", "gyro.csv:2:5: \"two\" is not a number");
    expect_refused(head + "0,1,2\n", "gyro.csv:2:6: the row has 3 cells and the first line 4");
    expect_refused("t,wx,wy,wz\r\n0,1,2\r\n", "gyro.csv:2:6: the row has 3 cells");
    expect_refused(head + "0.1,1,2,3\n0.1,1,2,3\n",
                   "gyro.csv:3:1: the time 0.1 s does not come after 0.1 s");
    expect_refused(head + "0,5,1,0,2,0,3,0\n",
                   "gyro.csv:2:9: the row has 8 cells and the first line 4; where numbers have "
                   "decimal commas");
    expect_refused("t;wx;wy;wz\n0;1,5;2;3.25\n",
                   "gyro.csv:2:9: \"3.25\" has a decimal point, and earlier numbers have commas");
    expect_refused("t;wx;wy;wz\n0;1.234,5;2;3\n", "gyro.csv:2:3: \"1.234,5\" is not a number");
    expect_refused("t,qw,qx,qy,qz\n0,1,1,0,0\n", "gyro.csv:2:3: the quaternion has length 1.41421");
    expect_refused("t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,-1\n",
                   "gyro.csv:2:3: the matrix is a reflection");
    expect_refused("t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,2,0,0,0,1\n",
                   "gyro.csv:2:3: the matrix is not orthogonal");
    expect_refused(std::string(2 << 20, 'x'), "gyro.csv:1:1: the line is longer than 1 MiB");
}

TEST(MeasuredMotion, SaysWhatOtherKindsOfTextAre) {
    const std::string utf8 = "t,wx,wy,wz\n0,1,2,3\n1,2,3,4\n";
    std::string little, big;
    for (const char c : utf8) {
        little += {c, '\0'};
        big += {'\0', c};
    }
    const std::string save = "save the table as UTF-8 text";
    expect_refused("\xFF\xFE" + little, "gyro.csv:1:1: the table is UTF-16; " + save);
    expect_refused("\xFE\xFF" + big, "gyro.csv:1:1: the table is UTF-16; " + save);
    expect_refused(little, "gyro.csv:1:1: the table is UTF-16 or no text; " + save);
    expect_refused(big, "gyro.csv:1:1: the table is UTF-16 or no text; " + save);
    std::string old = utf8;
    std::replace(old.begin(), old.end(), '\n', '\r');
    expect_refused(old, "gyro.csv:1:11: the lines end in CR alone");
    for (std::string more; old.size() < (3u << 20);) old += "2,3,4,5\r";
    expect_refused(old, "gyro.csv:1:11: the lines end in CR alone");
    // Ends of lines that were read before.
    const std::string two = "t,wx,wy,wz\r\r\n0,1,2,3\r\r\n";
    EXPECT_EQ(read_measured(two, "gyro.csv").rows.size(), 1u);
}

}  // namespace

}  // namespace poinsot
