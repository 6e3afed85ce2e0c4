// A starter bot for {{game}}: copy it and make it better. It needs nothing but C++17.
//
{{#codingame}}
// It speaks CodinGame's lines: words and numbers. The referee sends some before the first turn and some every turn, and
// every turn it waits for an answer. Use stderr for your own notes: std::cerr << "hello\n";
{{/codingame}}
{{#json}}
// The referee sends one JSON object a line: a "setup", a "turn" for every turn, and an "end". Every "turn" is answered
// by one line. Use stderr for your own notes: std::cerr << "hello\n";
{{/json}}
{{#json}}
#include <cctype>
{{/json}}
#include <cmath>
#include <cstdlib>
#include <iostream>
{{#json}}
#include <sstream>
{{/json}}
#include <string>
#include <vector>
{{#records}}

struct {{type}} {
{{#fields}}
    {{#int}}int{{/int}}{{#real}}double{{/real}}{{#word}}std::string{{/word}} {{name}};
{{/fields}}
};
{{/records}}

// Reading and writing: see the end of this file. There is nothing to change there.
{{#json}}
struct Json {
    std::string text;                   // of a string; also true, false and null
    double value = -1;                  // of a number
    std::vector<std::string> keys;      // of an object
    std::vector<Json> items;            // of an object or array

    const Json& operator[](const std::string& key) const;
};

Json readFrame();
int integer(const Json& values, const std::string& key);
double number(const Json& values, const std::string& key);
std::string word(const Json& values, const std::string& key);
{{/json}}
{{#codingame}}
int integer();
double number();
std::string word();
{{/codingame}}
{{#records}}
{{type}} read{{type}}({{#json}}const Json& each{{/json}});
{{/records}}
{{#codingame}}

// Prints a line of words.
template <typename First, typename... Rest>
void print(const First& first, const Rest&... rest) {
    std::cout << first;
    ((std::cout << ' ' << rest), ...);
    std::cout << '\n';
}
{{/codingame}}
{{#json}}

inline void write(std::ostream& out, const char* text) { out << '"' << text << '"'; }
inline void write(std::ostream& out, const std::string& text) { write(out, text.c_str()); }
inline void write(std::ostream& out, bool value) { out << (value ? "true" : "false"); }

template <typename Number>
void write(std::ostream& out, Number value) { out << value; }

inline void pairs(std::ostream&) { }

template <typename Value, typename... Rest>
void pairs(std::ostream& out, const char* key, const Value& value, const Rest&... rest) {
    write(out, key);
    out << ": ";
    write(out, value);
    out << (sizeof...(rest) > 0 ? ", " : "");
    pairs(out, rest...);
}

// A JSON object of keys and values, one after the other.
template <typename... Pairs>
std::string command(const Pairs&... of) {
    std::ostringstream out;
    out.precision(12);
    out << '{';
    pairs(out, of...);
    out << '}';
    return out.str();
}
{{/json}}
{{#distance}}

double distance(double x, double y, double otherX, double otherY) {
    return std::hypot(otherX - x, otherY - y);
}
{{/distance}}
{{#degrees}}

// How many degrees, 0..180, a heading is off the direction from a place to another.
double degreesOff(double x, double y, double heading, double otherX, double otherY) {
    double wanted = std::atan2(otherY - y, otherX - x) * 180 / std::acos(-1.0);
    return std::abs(std::remainder(wanted - heading, 360));
}
{{/degrees}}

int main() {
{{#json}}
    Json frame = readFrame();               // before the first turn
{{/json}}
{{#codingame}}
    // Before the first turn.
{{/codingame}}
{{#readings}}
{{#every}}
    for (;;) {
{{#json}}
        frame = readFrame();                // every turn
{{/json}}
{{#codingame}}
        // Every turn. All of it has to be read, whether you use it or not.
{{/codingame}}
{{/every}}
{{#inputs}}
{{#variables}}
    {{step}}[[maybe_unused]] const auto {{name}} = {{kind}}({{#json}}frame, "{{key}}"{{/json}});
{{/variables}}
{{#record}}
    {{step}}const {{type}} {{name}} = read{{type}}({{#json}}frame["{{key}}"]{{/json}});
{{/record}}
{{#list}}
    {{step}}std::vector<{{type}}> {{name}};
{{#json}}
    {{step}}for (const Json& each : frame["{{key}}"].items) {
    {{step}}    {{name}}.push_back(read{{type}}(each));
    {{step}}}
{{/json}}
{{#codingame}}
    {{step}}for (int k = 0; k < {{count}}; k++) {
    {{step}}    {{name}}.push_back(read{{type}}());
    {{step}}}
{{/codingame}}
{{/list}}
{{/inputs}}
{{/readings}}

        // Change this: it decides what you answer.
{{#notes}}
        // {{note}}
{{/notes}}
{{#json}}
        std::vector<std::string> answers;
{{/json}}
{{#commands}}
{{#list}}
{{#indexed}}
        for (std::size_t index = 0; index < {{list}}.size(); index++) {
            const auto& {{name}} = {{list}}[index];
{{/indexed}}
{{^indexed}}
        for (const auto& {{name}} : {{list}}) {
{{/indexed}}
{{/list}}
{{^list}}
        {
{{/list}}
{{#where}}
            if (!({{where}})) {
                continue;
            }
{{/where}}
{{#locals}}
            const auto {{name}} = {{value}};
{{/locals}}
{{#nearest}}
            const {{type}}* {{name}} = nullptr;             // the nearest one, if there is any
            for (const auto& each : {{list}}) {
{{#where}}
                if (!({{where}})) {
                    continue;
                }
{{/where}}
                if (!{{name}} || distance({{from}}.x, {{from}}.y, each.x, each.y)
                    < distance({{from}}.x, {{from}}.y, {{name}}->x, {{name}}->y)) {
                    {{name}} = &each;
                }
            }
{{/nearest}}
{{#choices}}
{{#if}}
            if ({{when}}) {
{{/if}}
{{#elseif}}
            } else if ({{when}}) {
{{/elseif}}
{{#else}}
            } else {
{{/else}}
            {{#nested}}    {{/nested}}{{#codingame}}print({{#parts}}{{#wrap}}
                    {{/wrap}}{{value}}{{^last}}, {{/last}}{{/parts}}){{/codingame}}{{#json}}answers.push_back(command({{#parts}}{{#wrap}}
                    {{/wrap}}"{{key}}", {{value}}{{^last}}, {{/last}}{{/parts}})){{/json}};
{{#end}}
            }
{{/end}}
{{/choices}}
        }
{{/commands}}
{{#json}}
{{#answer}}
        std::cout << "{\"{{answer}}\": [";
        for (std::size_t k = 0; k < answers.size(); k++) {
            std::cout << (k == 0 ? "" : ", ") << answers[k];
        }
        std::cout << "]}\n";
{{/answer}}
{{^answer}}
        std::cout << answers[0] << '\n';
{{/answer}}
{{/json}}
        std::cout << std::flush;            // without it the referee would wait in vain
    }
}

// Reading. There is nothing to change from here on.
{{#records}}

{{type}} read{{type}}({{#json}}const Json& each{{/json}}) {
    return {{type}}{ {{#fields}}{{#wrap}}
        {{/wrap}}{{kind}}({{#json}}each, "{{key}}"{{/json}}){{^last}}, {{/last}}{{/fields}} };
}
{{/records}}
{{#codingame}}

// The next word; the program ends when the referee closes our input.
std::string word() {
    std::string next;
    if (!(std::cin >> next)) {
        std::exit(0);
    }
    return next;
}

int integer() {
    return std::atoi(word().c_str());
}

double number() {
    return std::atof(word().c_str());
}
{{/codingame}}
{{#json}}

// A small reader of JSON.
struct JsonReader {
    const std::string& text;
    std::size_t at = 0;

    explicit JsonReader(const std::string& line) : text(line) { }

    char next() {
        while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at]))) {
            at++;
        }
        return at < text.size() ? text[at] : '\0';
    }

    bool skip(char wanted) {
        bool there = next() == wanted || next() == '\0';
        at += there ? 1 : 0;
        return there;
    }

    Json value() {
        Json found;
        if (next() == '{') {
            for (at++; !skip('}'); ) {
                at += next() == ',' ? 1 : 0;
                next();
                found.keys.push_back(string());
                skip(':');
                found.items.push_back(value());
            }
        } else if (next() == '[') {
            for (at++; !skip(']'); ) {
                at += next() == ',' ? 1 : 0;
                found.items.push_back(value());
            }
        } else if (next() == '"') {
            found.text = string();
        } else {
            std::size_t from = at;
            while (at < text.size() && std::string(",]} \t").find(text[at]) == std::string::npos) {
                at++;
            }
            found.text = text.substr(from, at - from);
            char* end = nullptr;
            double value = std::strtod(found.text.c_str(), &end);
            found.value = end == found.text.c_str() ? -1 : value;
        }
        return found;
    }

    std::string string() {
        std::string read;
        for (at++; at < text.size() && text[at] != '"'; at++) {
            char c = text[at];
            if (c == '\\') {
                c = text[++at];
                if (c == 'u') {                 // a character beyond ASCII becomes a question mark
                    int code = std::stoi(text.substr(at + 1, 4), nullptr, 16);
                    c = code < 128 ? static_cast<char>(code) : '?';
                    at += 4;
                } else {
                    c = c == 'n' ? '\n' : c == 't' ? '\t' : c == 'r' ? '\r' : c == 'b' ? '\b' : c == 'f' ? '\f' : c;
                }
            }
            read += c;
        }
        at++;
        return read;
    }
};

const Json& Json::operator[](const std::string& key) const {
    static const Json NONE;
    for (std::size_t k = 0; k < keys.size(); k++) {
        if (keys[k] == key) {
            return items[k];
        }
    }
    return NONE;
}

// The next frame; the program ends with the last one.
Json readFrame() {
    std::string line;
    if (!std::getline(std::cin, line)) {
        std::exit(0);
    }
    Json frame = JsonReader(line).value();
    if (frame["type"].text == "end") {
        std::exit(0);
    }
    return frame;
}

// A number of an object, -1 if there is none.
double number(const Json& values, const std::string& key) {
    return values[key].value;
}

int integer(const Json& values, const std::string& key) {
    return static_cast<int>(number(values, key));
}

std::string word(const Json& values, const std::string& key) {
    return values[key].text;
}
{{/json}}
