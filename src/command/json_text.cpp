#include "command/json_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "command/json_values.h"

namespace pectin::command_json {

namespace {

// Shortens nlohmann's "[json.exception.…] parse error at line 1, column 9: syntax error while
// parsing X - unexpected Y; last read: '…'; expected Z" to "unexpected Y; expected Z".
std::string reason(std::string text) {
    if (const auto dash = text.find(" - "); dash != text.npos) text.erase(0, dash + 3);
    if (const auto read = text.find("; last read: '"); read != text.npos) {
        const auto expected = text.rfind("'; expected ");
        text.erase(read,
                   expected == text.npos || expected < read ? text.npos : expected + 1 - read);
    }
    return text;
}

// Refuses objects that have a field twice and accepts everything else. A callback of json::parse
// could do the same, but then every end of an object would cost a pass over the enclosing array.
class RepeatedFields : public nlohmann::json_sax<json> {
  public:
    bool start_object(std::size_t) override {
        fields_.emplace_back();
        return true;
    }
    bool end_object() override {
        fields_.pop_back();
        return true;
    }
    bool key(string_t& name) override {
        if (fields_.back().insert(name).second) return true;
        throw Problem("the field " + in_quotes(name) + " is given twice; give it once");
    }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    // json::parse reports the error.
    bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
        return false;
    }

  private:
    std::vector<std::set<std::string>> fields_;  // for each object that is open
};

}  // namespace

json parse_strictly(std::string_view text) {
    // nlohmann-json words this differently from version to version.
    if (text.empty()) {
        throw Problem("not valid JSON at column 1: unexpected end of input; expected a value");
    }
    RepeatedFields repeated;
    json::sax_parse(text.begin(), text.end(), &repeated);
    try {
        return json::parse(text.begin(), text.end());
    } catch (const json::parse_error& error) {
        throw Problem("not valid JSON at column " + std::to_string(error.byte) + ": " +
                      reason(error.what()));
    } catch (const json::out_of_range& error) {
        // nlohmann's text ends with the number in single quotes.
        std::string digits = error.what();
        digits.erase(0, digits.find('\'') + 1);
        digits.erase(std::min(digits.find('\''), kMaxQuoted));
        throw Problem("the number " + digits + " is too large; the largest is 1.797e308");
    }
}

}  // namespace pectin::command_json
