#include "platform/background.h"

#include <exception>
#include <new>

#include "text/catalogue.h"

namespace viewing {

Error failure_of_work() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return Error{tr("the memory does not suffice for this work: it is given up")};
    } catch (const std::exception& thrown) {
        return Error{say("this work is given up: {reason}", "reason"_a = thrown.what())};
    } catch (...) {
        return Error{tr("this work is given up, nobody knows why")};
    }
}

}  // namespace viewing
