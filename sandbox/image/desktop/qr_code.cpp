#include "image/qr_code.h"

#include <qrencode.h>

#include <memory>

#include "text/catalogue.h"
#include "text/numbers.h"

namespace viewing {
namespace {

using Encoded = std::unique_ptr<QRcode, decltype(&QRcode_free)>;

Encoded encode(std::string_view text, int version, QRecLevel correction) {
    return {QRcode_encodeData(static_cast<int>(text.size()), reinterpret_cast<const unsigned char*>(text.data()),
                              version, correction),
            QRcode_free};
}

}  // namespace

Result<QrCode> qr_code(std::string_view text) {
    if (text.size() > most_qr_bytes)
        return Error{say("The link has {count} characters; a QR code holds at most {most}.",
                         "count"_a = grouped_number(static_cast<std::int64_t>(text.size())),
                         "most"_a = grouped_number(static_cast<std::int64_t>(most_qr_bytes)))};
    Encoded best = encode(text, 0, QR_ECLEVEL_L);
    if (!best) return Error{tr("The link is empty.")};
    for (const QRecLevel correction : {QR_ECLEVEL_M, QR_ECLEVEL_Q, QR_ECLEVEL_H})
        if (Encoded better = encode(text, best->version, correction); better && better->width == best->width)
            best = std::move(better);
    QrCode code;
    code.modules = best->width;
    const auto count = static_cast<std::size_t>(best->width * best->width);
    for (std::size_t i = 0; i < count; ++i) code.dark.push_back((best->data[i] & 1U) != 0);
    return code;
}

}  // namespace viewing
