// Debian's compiler runtime for wasm was built with a stack protector, which asks the C library for
// these; wasi-libc has none.
#include <cstdint>
#include <cstdlib>

extern "C" {
std::uintptr_t __stack_chk_guard = 0x595e9fbd;
[[noreturn]] void __stack_chk_fail() { std::abort(); }
}
