// The program's entry point. Everything it does starts from the command line; read cli/command_line.cpp next.
#include "cli/command_line.h"
#include "cli/signals.h"
#include "platform/heap.h"
#include "platform/leave.h"

int main(int argc, char** argv) {
    viewing::reserve_heap();
    viewing::end_cleanly_by_signals();
    const int first = argc > 0 ? 1 : 0;
    viewing::leave(viewing::run_command_line({argv + first, argv + argc}));
}
