#include "measured/measured_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include "error/error.h"
#include "measured/table_faults.h"
#include "measured/table_heading.h"
#include "text/nearest.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr double rotation_tolerance = 1e-3;

std::string_view trimmed(std::string_view text) {
    const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return text;
}

void split(std::string_view line, char separator, std::vector<std::string_view>& cells) {
    cells.clear();
    std::size_t begin = 0;
    bool is_quoted = false;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"') is_quoted = !is_quoted;
        if (i < line.size() && (is_quoted || line[i] != separator)) continue;
        cells.push_back(line.substr(begin, i - begin));
        begin = i + 1;
    }
}

// Whether a table is named after another sensor than a gyroscope, as apps name theirs.
bool is_of_another_sensor(std::string_view name) {
    std::string stem(name.substr(name.find_last_of("/\\") + 1));
    for (char& c : stem) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    constexpr std::array<std::string_view, 4> sensors{"accel", "gravity", "magnet", "orientation"};
    return std::any_of(sensors.begin(), sensors.end(), [&stem](std::string_view sensor) {
        return stem.find(sensor) != std::string::npos;
    });
}

}  // namespace

MeasuredReader::MeasuredReader(std::string name, TakeRow take)
    : name_(std::move(name)), take_(std::move(take)) {}

void MeasuredReader::read(std::string_view bytes) {
    while (!bytes.empty()) {
        const std::size_t end = bytes.find('\n');
        if (end == std::string_view::npos) {
            rest_ += bytes;
            constexpr std::size_t longest_line = 1 << 20;
            if (rest_.size() > longest_line) {
                ++line_number_;
                if (line_number_ == 1) check_text(rest_);
                refuse_at(line_number_, 1,
                          "the line is longer than 1 MiB; give a table of text with a row a line");
            }
            return;
        }
        if (rest_.empty()) {
            take_line(bytes.substr(0, end));
        } else {
            rest_ += bytes.substr(0, end);
            take_line(rest_);
            rest_.clear();
        }
        bytes.remove_prefix(end + 1);
    }
}

void MeasuredReader::finish() {
    if (!rest_.empty()) {
        const std::string last = std::exchange(rest_, {});
        take_line(last);
    }
    if (n_columns_ == 0)
        refuse_at(1, 1, "the file is empty; give a table whose first line names its columns");
    if (!has_rows_)
        refuse_at(line_number_ + 1, 1, "the table has no rows; give instants with values");
}

void MeasuredReader::refuse(std::size_t cell, const std::string& what) const {
    // Cells point into the line. Columns count bytes, as in messages about scenes.
    const std::size_t column =
        cell < cells_.size() ? static_cast<std::size_t>(cells_[cell].data() - line_.data()) + 1
                             : line_.size() + 1;
    refuse_at(line_number_, column, what);
}

void MeasuredReader::refuse_at(std::size_t line, std::size_t column, std::string_view what) const {
    throw InputError({name_, static_cast<int>(line), static_cast<int>(column)},
                     fmt::format("{}:{}:{}: {}", printable(name_), line, column, what));
}

void MeasuredReader::take_line(std::string_view line) {
    ++line_number_;
    if (line_number_ == 1) {
        check_text(line);
        if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    }
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (trimmed(line).empty()) return;
    line_ = line;
    if (n_columns_ == 0)
        take_header(line);
    else
        take_row(line);
}

// Refuses a first line that another kind of file has, before its columns are missed.
void MeasuredReader::check_text(std::string_view line) const {
    if (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF"))
        refuse_at(1, 1, "the table is UTF-16; save the table as UTF-8 text");
    if (line.starts_with("PK\x03\x04") || line.starts_with("\xD0\xCF\x11\xE0"))
        refuse_at(1, 1, "the file is a spreadsheet or an archive; export the table as CSV");
    if (line.find('\0') != std::string_view::npos)
        refuse_at(1, 1, "the table is UTF-16 or no text; save the table as UTF-8 text");
    const std::size_t end = line.find('\r');
    const std::size_t more = line.find_first_not_of('\r', end);
    if (end != std::string_view::npos && more != std::string_view::npos)
        refuse_at(1, end + 1,
                  "the lines end in CR alone, as on old Macs; save the table with lines that end "
                  "in LF or CR LF");
}

void MeasuredReader::take_header(std::string_view line) {
    const auto n_of = [line](char c) { return std::count(line.begin(), line.end(), c); };
    separator_ = n_of('\t') > 0 ? '\t' : n_of(';') > 0 ? ';' : ',';
    split(line, separator_, cells_);
    n_columns_ = cells_.size();
    factors_.assign(n_columns_, 1.0);
    // By kind: the highest rank, of which the columns are taken.
    std::array<int, n_column_kinds> ranks{};
    ranks.fill(-1);
    for (const std::string_view cell : cells_) {
        const TableHeading heading = table_heading_of(cell);
        int& rank = ranks[static_cast<std::size_t>(heading.kind)];
        rank = std::max(rank, heading.rank);
    }
    // Beside attitudes, x, y and z alone are a place.
    const bool has_attitudes = ranks[static_cast<std::size_t>(ColumnKind::quaternion)] >= 0 ||
                               ranks[static_cast<std::size_t>(ColumnKind::matrix)] >= 0;
    for (std::size_t i = 0; i < n_columns_; ++i) {
        const TableHeading heading = table_heading_of(cells_[i]);
        const bool is_short = heading.kind == ColumnKind::omega && heading.rank < sure_rank;
        if (heading.kind == ColumnKind::other || (is_short && has_attitudes) ||
            heading.rank < ranks[static_cast<std::size_t>(heading.kind)])
            continue;
        const auto component = static_cast<std::size_t>(heading.component);
        int& column = heading.kind == ColumnKind::time         ? column_of_time_
                      : heading.kind == ColumnKind::omega      ? column_of_omega_[component]
                      : heading.kind == ColumnKind::quaternion ? column_of_quaternion_[component]
                                                               : column_of_matrix_[component];
        if (column >= 0)
            refuse(i,
                   fmt::format("two columns say the same, \"{}\" and \"{}\"; take one out",
                               printable(unquoted_cell(cells_[static_cast<std::size_t>(column)])),
                               printable(unquoted_cell(cells_[i]))));
        column = static_cast<int>(i);
        if (!heading.is_unit_known) {
            const bool is_time = heading.kind == ColumnKind::time;
            refuse(i, fmt::format("\"{}\" is no unit of {}; write it as in \"{} ({})\"",
                                  printable(heading.unit), is_time ? "time" : "angular velocity",
                                  printable(heading.name), is_time ? "s" : "rad/s"));
        }
        factors_[i] = heading.si_in_unit;
        if (is_short && is_of_another_sensor(name_))
            refuse(i, "by the table's name this is no column of ω; give the gyroscope's table");
    }
    check_columns();
}

void MeasuredReader::check_columns() const {
    const auto n_of = [](const auto& columns) {
        return std::count_if(columns.begin(), columns.end(),
                             [](int column) { return column >= 0; });
    };
    const auto refuse_missing = [this](std::string_view what) {
        constexpr std::size_t most_columns = 12;
        std::string columns;
        for (std::size_t i = 0; i < std::min(n_columns_, most_columns); ++i)
            columns +=
                fmt::format("{}\"{}\"", i == 0 ? "" : ", ", printable(unquoted_cell(cells_[i])));
        refuse_at(line_number_, 1,
                  fmt::format("the first line names no column for {}; it has {}{}", what, columns,
                              n_columns_ > most_columns ? ", …" : ""));
    };
    if (column_of_time_ < 0) refuse_missing("the time; name one \"time\", or \"time (ms)\"");
    if (const auto n = n_of(column_of_omega_); n > 0 && n < 3)
        refuse_missing("each component of ω; name three, as omega_x, omega_y, omega_z");
    if (const auto n = n_of(column_of_quaternion_); n > 0 && n < 4)
        refuse_missing("each component of the quaternion; name four, as q_w, q_x, q_y, q_z");
    if (const auto n = n_of(column_of_matrix_); n > 0 && n < 9)
        refuse_missing("each element of the matrix; name nine, as r11, r12, … r33");
    if (has_quaternion() && has_matrix())
        refuse_at(line_number_, 1, "the table has quaternions and matrices; take one of them out");
    if (!has_omega() && !has_attitude())
        refuse_missing(
            "ω or the attitude; name three omega_x, omega_y, omega_z, or four q_w, q_x, q_y, q_z");
}

double MeasuredReader::number_in(int column) {
    const auto i = static_cast<std::size_t>(column);
    std::string cell(unquoted_cell(cells_[i]));
    // A comma within a cell is no separator, so that it is the decimal one, where no other number
    // of the table has a point.
    const std::size_t mark = cell.find_first_of(".,");
    if (mark != std::string::npos && cell.find_first_of(".,", mark + 1) == std::string::npos) {
        if (decimal_mark_ != '\0' && decimal_mark_ != cell[mark])
            refuse(i, fmt::format("\"{}\" has a decimal {}, and earlier numbers have {}; write all "
                                  "with points",
                                  printable(cell), cell[mark] == ',' ? "comma" : "point",
                                  cell[mark] == ',' ? "points" : "commas"));
        decimal_mark_ = cell[mark];
        cell[mark] = '.';
    }
    const auto number = number_of<double>(without_plus(cell));
    if (!number) {
        if (cell.empty()) refuse(i, "the cell is empty; leave out rows without values");
        refuse(i, fmt::format("\"{}\" is not a number", printable(cell)));
    }
    if (!std::isfinite(*number * factors_[i]))
        refuse(i, fmt::format("\"{}\" is not a finite number", printable(cell)));
    return *number * factors_[i];
}

void MeasuredReader::take_row(std::string_view line) {
    split(line, separator_, cells_);
    // As spreadsheets leave them at the end.
    if (std::all_of(cells_.begin(), cells_.end(),
                    [](std::string_view cell) { return unquoted_cell(cell).empty(); }))
        return;
    if (cells_.size() != n_columns_)
        refuse(
            std::min(cells_.size(), n_columns_),
            fmt::format("the row has {} cells and the first line {}{}", cells_.size(), n_columns_,
                        separator_ == ',' && cells_.size() > n_columns_
                            ? "; where numbers have decimal commas, separate the columns by "
                              "semicolons or tabs"
                            : ""));
    MeasuredRow row;
    row.time_s = number_in(column_of_time_);
    if (has_rows_ && !(row.time_s > last_time_s_))
        refuse(static_cast<std::size_t>(column_of_time_),
               fmt::format("the time {} s does not come after {} s; sort the rows, each "
                           "instant once",
                           row.time_s, last_time_s_));
    if (has_omega())
        for (int k = 0; k < 3; ++k)
            row.omega_body[k] = number_in(column_of_omega_[static_cast<std::size_t>(k)]);
    if (has_quaternion()) {
        Eigen::Vector4d q;
        for (int k = 0; k < 4; ++k)
            q[k] = number_in(column_of_quaternion_[static_cast<std::size_t>(k)]);
        if (!(std::abs(q.norm() - 1.0) <= rotation_tolerance))
            refuse(static_cast<std::size_t>(column_of_quaternion_[0]),
                   fmt::format("the quaternion has length {:.6g}; attitudes are unit quaternions",
                               q.norm()));
        row.space_from_body = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
    } else if (has_matrix()) {
        Eigen::Matrix3d r;
        for (int k = 0; k < 9; ++k)
            r(k / 3, k % 3) = number_in(column_of_matrix_[static_cast<std::size_t>(k)]);
        const double fault =
            (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
        if (!(fault <= rotation_tolerance) || r.determinant() < 0.0)
            refuse(static_cast<std::size_t>(column_of_matrix_[0]),
                   r.determinant() < 0.0
                       ? "the matrix is a reflection; attitudes are rotations"
                       : fmt::format(
                             "the matrix is not orthogonal, by {:.2g}; attitudes are rotations",
                             fault));
        row.space_from_body = Eigen::Quaterniond(r).normalized();
    }
    last_time_s_ = row.time_s;
    has_rows_ = true;
    take_(row);
}

MeasuredMotion read_measured(std::string_view text, const std::string& name) {
    MeasuredMotion motion;
    MeasuredReader reader(name, [&motion](const MeasuredRow& row) { motion.rows.push_back(row); });
    reader.read(text);
    reader.finish();
    motion.has_omega = reader.has_omega();
    motion.has_attitude = reader.has_attitude();
    return motion;
}

Eigen::Vector3d turn_between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
    Eigen::Quaterniond turn = from.conjugate() * to;
    if (turn.w() < 0.0) turn.coeffs() *= -1.0;
    const double sine = turn.vec().norm();
    return turn.vec() * (sine > 0.0 ? 2.0 * std::atan2(sine, turn.w()) / sine : 2.0);
}

// From sixth differences, to which a smooth motion adds little: the squares of their coefficients,
// 1, 6, 15, 20 and so on, sum up to 924.
double attitude_noise_of(std::span<const MeasuredRow> rows) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr std::array<double, 3> coefficients{15.0, -6.0, 1.0};
    double sum = 0.0;
    std::size_t n = 0;
    const auto add = [&](std::span<const MeasuredRow> stretch) {
        for (std::size_t i = 3; i + 3 < stretch.size(); ++i, ++n) {
            Eigen::Vector3d sixth = Eigen::Vector3d::Zero();
            for (std::size_t k = 0; k < 3; ++k)
                for (const std::size_t at : {i - k - 1, i + k + 1})
                    sixth += coefficients[k] *
                             turn_between(stretch[i].space_from_body, stretch[at].space_from_body);
            sum += sixth.squaredNorm();
        }
    };
    for (const auto& stretch : stretches_of(rows, -infinity, infinity)) add(stretch);
    if (n == 0) add(rows);
    return n == 0 ? 0.0 : std::sqrt(sum / 924.0 / static_cast<double>(3 * n));
}

void add_omega_by_differences(MeasuredMotion& motion) {
    std::vector<MeasuredRow>& rows = motion.rows;
    if (motion.has_omega || rows.size() < 2) return;
    std::vector<bool> has_gap_before(rows.size() + 1, false);  // or the table's end
    has_gap_before.front() = has_gap_before.back() = true;
    for (const MeasuredGap& gap : gaps_of(rows)) has_gap_before[gap.before + 1] = true;
    const auto turn = [&rows](std::size_t before, std::size_t after) {
        return turn_between(rows[before].space_from_body, rows[after].space_from_body);
    };
    // The noise of a turn between two rows, 2 % of it.
    constexpr double widest_rad = 0.4, most_noise = 0.02;
    const double wanted_rad =
        std::min(widest_rad, std::sqrt(2.0) * attitude_noise_of(rows) / most_noise);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        // Not across a gap, in which ω changes; but from a single row there is no other way.
        const bool is_alone = has_gap_before[i] && has_gap_before[i + 1];
        const bool takes_before = is_alone ? i > 0 : !has_gap_before[i];
        const bool takes_after = is_alone ? i + 1 < rows.size() : !has_gap_before[i + 1];
        std::size_t before = takes_before ? i - 1 : i, after = takes_after ? i + 1 : i;
        // As far on either side, so that the difference stays one of second order.
        while (!is_alone && turn(before, after).norm() < wanted_rad) {
            const bool may_before = !has_gap_before[before], may_after = !has_gap_before[after + 1];
            if ((takes_before && !may_before) || (takes_after && !may_after)) break;
            const std::size_t from = takes_before ? before - 1 : before;
            const std::size_t to = takes_after ? after + 1 : after;
            if (turn(from, to).norm() > widest_rad) break;
            before = from;
            after = to;
        }
        rows[i].omega_body = turn(before, after) / (rows[after].time_s - rows[before].time_s);
        rows[i].is_omega_derived = true;
    }
}

}  // namespace poinsot
