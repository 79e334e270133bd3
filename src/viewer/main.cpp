#include <viewer/session/program.h>

#include <program/allocator.h>

int main(int argc, char** argv) {
    cdr::program::keepFreedMemory();
    cdr::program::useLargePages();
    return cdr::viewer::exitStatusOf("cdr-viewer", [&] {
        cdr::viewer::Arguments arguments;
        if (const auto status = cdr::viewer::parseViewer(argc, argv, arguments)) {
            return *status;
        }
        cdr::viewer::runViewer(arguments);
        return 0;
    });
}
