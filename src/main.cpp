// Entry: hands over to the command line; the only catch, the only exit codes.
#include <cstdio>
#include <exception>
#include <new>

#include "cli/program.h"
#include "error/error.h"

int main(int argc, char** argv) {
    try {
        return poinsot::run_program(argc, argv);
    } catch (const poinsot::InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    } catch (const poinsot::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    } catch (const std::bad_alloc&) {
        std::fputs("out of memory; ask for a smaller picture or a shorter film\n", stderr);
        return 3;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "poinsot: %s\n", error.what());
        return 3;
    }
}
