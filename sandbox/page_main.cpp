// The browser's entry point.
#include "app/browser/page.h"

int main() {
    viewing::open_page();
}
