#include <cdr/platform/json_text.h>

namespace cdr::platform {

std::string textOf(const nlohmann::ordered_json& json, int indent) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace cdr::platform
