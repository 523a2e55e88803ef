#include "production/sampling/files/table_file.h"

#include <cstdint>

#include "system/files/atomic_file.h"

namespace poinsot {

void write_table(const SampleTable& table, const TableFormat& format,
                 const std::filesystem::path& path) {
    AtomicFile file(path);
    format.write(table, [&file](std::string_view bytes) {
        file.write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    });
    file.commit();
}

}  // namespace poinsot
