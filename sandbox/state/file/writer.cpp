// Writes a whole state as a JSON tree; reader.cpp does the reverse.
#include <algorithm>

#include "state/file/reader.h"

namespace viewing {

Json params_as_document(Params params) {
    Json document = Json::object();
    for (const Field& field : fields()) {
        std::string pointer = "/" + std::string(field.path);
        std::replace(pointer.begin(), pointer.end(), '.', '/');
        document[Json::json_pointer(pointer)] = field_as_json(field, params);
    }
    return document;
}

}  // namespace viewing
