#include "platform/background.h"

#include <exception>
#include <new>

#include "text/catalogue.h"

namespace viewing {

Error failure_of_work() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return Error{tr("the computation stopped: not enough memory")};
    } catch (const std::exception& thrown) {
        return Error{say("the computation stopped: {reason}", "reason"_a = thrown.what())};
    } catch (...) {
        return Error{tr("the computation stopped for an unknown reason")};
    }
}

}  // namespace viewing
