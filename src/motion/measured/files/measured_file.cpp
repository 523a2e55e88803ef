#include "measured/files/measured_file.h"

#include "system/files/file_contents.h"

namespace poinsot {

void read_measured(const std::filesystem::path& file,
                   const std::function<void(const MeasuredColumns&)>& begin,
                   const MeasuredReader::TakeRow& take) {
    bool has_begun = false;
    MeasuredReader* self = nullptr;
    MeasuredReader reader(file.string(), [&](const MeasuredRow& row) {
        if (!has_begun) begin({self->has_omega(), self->has_attitude()});
        has_begun = true;
        take(row);
    });
    self = &reader;
    read_pieces(file, [&reader](std::string_view piece) { reader.read(piece); });
    reader.finish();
}

MeasuredMotion load_measured(const std::filesystem::path& file) {
    MeasuredMotion motion;
    read_measured(
        file,
        [&motion](const MeasuredColumns& columns) {
            motion.has_omega = columns.has_omega;
            motion.has_attitude = columns.has_attitude;
        },
        [&motion](const MeasuredRow& row) { motion.rows.push_back(row); });
    return motion;
}

}  // namespace poinsot
