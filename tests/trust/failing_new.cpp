// Preloaded by fault_matrix.py: makes the POINSOT_FAIL_NEW-th call of operator new by poinsot
// itself fail, and all later ones. Allocations of libraries succeed: we cannot fix out-of-memory
// errors in LLVM or FFmpeg.
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> n_asked{0};

long limit() {
    static const long value = [] {
        const char* text = std::getenv("POINSOT_FAIL_NEW");
        return text ? std::atol(text) : 0L;
    }();
    return value;
}

// The address range of the program's own code.
struct Range {
    std::uintptr_t from = 0, to = 0;
};

Range program_range() {
    Range range;
    // The first object reported is the program.
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* out) {
            for (int i = 0; i < info->dlpi_phnum; ++i) {
                const auto& part = info->dlpi_phdr[i];
                if (part.p_type != PT_LOAD || (part.p_flags & PF_X) == 0) continue;
                const std::uintptr_t from = info->dlpi_addr + part.p_vaddr;
                *static_cast<Range*>(out) = {from, from + part.p_memsz};
            }
            return 1;
        },
        &range);
    return range;
}

bool in_program(const void* address) {
    static const Range range = program_range();
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= range.from && at < range.to;
}

// Whether this is an instance of a standard library template that the program shares with its
// libraries: LLVM's strings grow in the program's own code.
bool in_shared_template(const void* address) {
    Dl_info info{};
    void* found = nullptr;
    if (dladdr1(address, &info, &found, RTLD_DL_SYMENT) == 0 || found == nullptr) return false;
    const auto* symbol = static_cast<const ElfW(Sym)*>(found);
    const auto from = reinterpret_cast<std::uintptr_t>(info.dli_saddr);
    return reinterpret_cast<std::uintptr_t>(address) < from + symbol->st_size;
}

// Whether the program is the caller. caller: of operator new.
bool program_asks(const void* caller) {
    if (!in_program(caller)) return false;
    if (!in_shared_template(caller)) return true;
    std::array<void*, 16> frames{};
    const int n = backtrace(frames.data(), static_cast<int>(frames.size()));
    bool is_above = false;
    for (int i = 0; i < n; ++i) {
        const void* const frame = frames[static_cast<std::size_t>(i)];
        is_above = is_above || frame == caller;
        if (is_above && !(in_program(frame) && in_shared_template(frame))) return in_program(frame);
    }
    return false;
}

// No failure before main: static initialisation succeeds or the program does not start.
std::atomic<bool> in_main{false};
int (*program_main)(int, char**, char**) = nullptr;

int main_marked(int argc, char** argv, char** environment) {
    in_main = true;
    return program_main(argc, argv, environment);
}

void* allocate(std::size_t size, const void* caller) {
    if (in_main && limit() != 0 && program_asks(caller)) {
        const long n = ++n_asked;
        if (limit() > 0 && n >= limit()) return nullptr;
    }
    return std::malloc(size == 0 ? 1 : size);
}

// With POINSOT_FAIL_NEW=-1 nothing fails, and the number of allocations is printed.
struct Report {
    ~Report() {
        if (limit() < 0) std::fprintf(stderr, "allocations: %ld\n", n_asked.load());
    }
} report;

}  // namespace

void* operator new(std::size_t size) {
    void* const memory = allocate(size, __builtin_return_address(0));
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
void* operator new[](std::size_t size) {
    void* const memory = allocate(size, __builtin_return_address(0));
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

// glibc's entry point of a program; main is replaced by a function that marks its start.
extern "C" int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv,
                                 void (*init)(), void (*fini)(), void (*end)(), void* stack) {
    using Start = int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(),
                          void (*)(), void*);
    program_main = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(main_marked, argc, argv, init, fini, end, stack);
}
