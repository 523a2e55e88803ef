// A motion that an instrument or another program recorded: rows of instants with the angular
// velocity, the attitude, or both, from a table of text (CSV).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// One row. What the table does not have is zero, and the identity.
struct MeasuredRow {
    double time_s = 0.0;
    Eigen::Vector3d omega_body = Eigen::Vector3d::Zero();  // rad/s, body (or instrument) axes
    Eigen::Quaterniond space_from_body = Eigen::Quaterniond::Identity();  // unit
    // ω is a difference of attitudes: a fit compares the attitudes instead.
    bool is_omega_derived = false;
};

// Reads a table piece by piece, so that a table of any length takes no more memory than a line.
//
// The first line names the columns; columns of other names are ignored. Time: "time", "t" or
// "timestamp". ω: "omega_body", "omega", "w", "gyroscope", "gyro" or "angular velocity" with x, y,
// z or 1, 2, 3, or these letters alone. Attitude, space from body: "q" or "quaternion" with w, x,
// y, z, or a matrix "r11" … "r33". Further names: measured/table_heading.h. Units stand in
// parentheses or brackets, "Gyroscope x (rad/s)", or at the end, "time_ms"; without them they are s
// and rad/s. Columns are separated by commas, semicolons or tabs, and a comma within a cell is a
// decimal comma. Rows whose cells are all empty are ignored.
class MeasuredReader {
 public:
    using TakeRow = std::function<void(const MeasuredRow& row)>;

    // `name` is the table's, for messages.
    MeasuredReader(std::string name, TakeRow take);

    // Takes the next bytes of the table, cut anywhere. Throws InputError `NAME:LINE:COLUMN: …` for
    // a column that is missing or named twice, a unit of another kind, a cell that is no finite
    // decimal number, instants that do not increase, and attitudes that are no rotation to 1e-3.
    void read(std::string_view bytes);
    // Ends the table. Throws as read does, and for a table without rows.
    void finish();

    bool has_omega() const { return column_of_omega_[0] >= 0; }
    bool has_attitude() const { return has_quaternion() || has_matrix(); }

 private:
    bool has_quaternion() const { return column_of_quaternion_[0] >= 0; }
    bool has_matrix() const { return column_of_matrix_[0] >= 0; }
    void take_line(std::string_view line);
    void check_text(std::string_view line) const;
    void take_header(std::string_view line);
    void take_row(std::string_view line);
    void check_columns() const;
    double number_in(int column);
    [[noreturn]] void refuse(std::size_t cell, const std::string& what) const;
    [[noreturn]] void refuse_at(std::size_t line, std::size_t column, std::string_view what) const;

    std::string name_;
    TakeRow take_;
    std::string rest_;  // of a line whose end has not come yet
    std::size_t line_number_ = 0;
    char separator_ = ',';
    char decimal_mark_ = '\0';  // that a number had; '\0': none had one
    std::size_t n_columns_ = 0;
    int column_of_time_ = -1;
    std::array<int, 3> column_of_omega_{-1, -1, -1};
    std::array<int, 4> column_of_quaternion_{-1, -1, -1, -1};
    std::array<int, 9> column_of_matrix_{-1, -1, -1, -1, -1, -1, -1, -1, -1};
    std::vector<double> factors_;  // SI units in one unit of each column
    std::vector<std::string_view> cells_;
    std::string_view line_;
    bool has_rows_ = false;
    double last_time_s_ = 0.0;
};

// A table as a whole.
struct MeasuredMotion {
    std::vector<MeasuredRow> rows;
    bool has_omega = false, has_attitude = false;
};

// Reads a whole table. Throws as MeasuredReader does.
MeasuredMotion read_measured(std::string_view text, const std::string& name);

// The turn that takes one attitude to another, the shorter way: axis times angle, in rad and body
// axes; log(from⁻¹ to).
Eigen::Vector3d turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to);

// The noise of attitudes, rad about an axis, as the rows scatter from one to the next. Between
// uneven instants it is too large; 0 for fewer than seven rows.
double attitude_noise_of(std::span<const MeasuredRow> rows);

// Fills ω of rows that have only attitudes: between its neighbours each row turns by ω times the
// time between them, beside a gap from its one neighbour. Exact for constant ω, else wrong by terms
// of second order in the step, beside a gap of first order. Where the noise of the attitudes would
// be more than 2 % of ω, the difference is that of rows farther apart, but not of more than 0.4
// rad. A single row keeps ω = 0.
void add_omega_by_differences(MeasuredMotion& motion);

}  // namespace poinsot
