// C++ exceptions by WebAssembly's own: Debian's libc++abi for wasm is built without. The compiler
// calls these functions (Itanium C++ ABI, "Exception Handling"; LLVM, "Exception Handling in
// WebAssembly"): a thrown value is a pointer, and a landing pad asks which of its handlers takes
// it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <new>
#include <typeinfo>

namespace __cxxabiv1 {

// As libc++abi lays it out: whether a handler of this type takes a thrown type. It moves the
// pointer to the part of the object that the handler sees.
class __shim_type_info : public std::type_info {
 public:
    ~__shim_type_info() override;
    virtual void noop1() const;
    virtual void noop2() const;
    virtual bool can_catch(const __shim_type_info* thrown, void*& object) const = 0;
};

}  // namespace __cxxabiv1

namespace {

using TypeInfo = __cxxabiv1::__shim_type_info;

// In WebAssembly a destructor returns its object.
using Destroy = void* (*)(void*);

// In front of each thrown object.
struct alignas(16) Thrown {
    const TypeInfo* type = nullptr;
    Destroy destroy = nullptr;
    void* seen = nullptr;  // what the handler sees of it
    int n_handlers = 0;
    bool is_rethrown = false;
    Thrown* outer = nullptr;  // handled when this one was thrown
};

Thrown* handled = nullptr;

void* object_of(Thrown* thrown) { return thrown + 1; }

std::uintptr_t take_unsigned(const std::uint8_t*& at) {
    std::uintptr_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
        const std::uint8_t byte = *at++;
        value |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
        if (byte < 0x80) return value;
    }
}

std::intptr_t take_signed(const std::uint8_t*& at) {
    std::uintptr_t value = 0;
    unsigned shift = 0;
    std::uint8_t byte = 0;
    do {
        byte = *at++;
        value |= static_cast<std::uintptr_t>(byte & 0x7f) << shift;
        shift += 7;
    } while (byte >= 0x80);
    if ((byte & 0x40) != 0 && shift < 32) value |= ~std::uintptr_t{0} << shift;
    return static_cast<std::intptr_t>(value);
}

// The number of the handler of a landing pad that takes what was thrown; 0: none. The table is that
// of LLVM's "language-specific data area".
std::intptr_t handler_of(Thrown& thrown, const std::uint8_t* table, std::uintptr_t landing_pad) {
    constexpr std::uint8_t omitted = 0xff;
    if (*table++ != omitted) take_unsigned(table);  // the start of landing pads
    const std::uint8_t* types = nullptr;
    if (*table++ != omitted) {
        const std::uintptr_t offset = take_unsigned(table);
        types = table + offset;
    }
    ++table;  // the encoding of call sites
    const std::uintptr_t size = take_unsigned(table);
    const std::uint8_t* const actions = table + size;
    std::uintptr_t action = 0;
    for (std::uintptr_t k = 0; k <= landing_pad && table < actions; ++k) {
        take_unsigned(table);
        action = take_unsigned(table);
    }
    if (action == 0 || types == nullptr) return 0;
    for (const std::uint8_t* at = actions + action - 1;;) {
        const std::intptr_t number = take_signed(at);
        if (number > 0) {
            const auto* const type = reinterpret_cast<const TypeInfo* const*>(types)[-number];
            void* seen = object_of(&thrown);
            if (type == nullptr || type->can_catch(thrown.type, seen)) {
                thrown.seen = seen;
                return number;
            }
        }
        const std::uint8_t* const here = at;
        const std::intptr_t next = take_signed(at);
        if (next == 0) return 0;
        at = here + next;
    }
}

}  // namespace

extern "C" {

struct LandingPad {
    std::uintptr_t number;
    std::uintptr_t table;
    std::uintptr_t handler;
} __wasm_lpad_context;

int _Unwind_CallPersonality(void* exception) {
    LandingPad& pad = __wasm_lpad_context;
    pad.handler = static_cast<std::uintptr_t>(
        handler_of(*static_cast<Thrown*>(exception),
                   reinterpret_cast<const std::uint8_t*>(pad.table), pad.number));
    return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
    void* const memory = std::malloc(sizeof(Thrown) + size);
    if (memory == nullptr) std::abort();
    return object_of(new (memory) Thrown);
}

void __cxa_free_exception(void* object) noexcept { std::free(static_cast<Thrown*>(object) - 1); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, Destroy destroy) {
    Thrown* const thrown = static_cast<Thrown*>(object) - 1;
    thrown->type = static_cast<const TypeInfo*>(type);
    thrown->destroy = destroy;
    thrown->seen = object;
    __builtin_wasm_throw(0, thrown);
}

void* __cxa_get_exception_ptr(void* exception) noexcept {
    return static_cast<Thrown*>(exception)->seen;
}

void* __cxa_begin_catch(void* exception) noexcept {
    Thrown* const thrown = static_cast<Thrown*>(exception);
    thrown->is_rethrown = false;
    if (thrown->n_handlers++ == 0) {
        thrown->outer = handled;
        handled = thrown;
    }
    return thrown->seen;
}

void __cxa_end_catch() {
    Thrown* const thrown = handled;
    if (thrown == nullptr || --thrown->n_handlers > 0) return;
    handled = thrown->outer;
    if (thrown->is_rethrown) return;
    if (thrown->destroy != nullptr) thrown->destroy(object_of(thrown));
    std::free(thrown);
}

[[noreturn]] void __cxa_rethrow() {
    if (handled == nullptr) std::terminate();
    handled->is_rethrown = true;
    __builtin_wasm_throw(0, handled);
}

}  // extern "C"
