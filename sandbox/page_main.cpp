// The browser's entry.
#include "app/browser/page.h"

int main() {
    viewing::open_page();
}
