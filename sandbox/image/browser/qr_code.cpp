#include "image/qr_code.h"

#include "text/catalogue.h"

namespace viewing {

Result<QrCode> qr_code(std::string_view) {
    return Error{tr("This page cannot draw QR codes; the program can.")};
}

}  // namespace viewing
