#include "language/value.h"

#include <algorithm>
#include <utility>

#include "base/number_text.h"
#include "language/quantity.h"

namespace filigree {

bool SymbolicCall::operator==(const SymbolicCall&) const = default;
bool ValueList::operator==(const ValueList&) const = default;

namespace {

bool is_sum_sign(std::string_view name) { return name == "+" || name == "-"; }
int tier_of(const SymbolicCall& operation) { return is_sum_sign(operation.name) ? 1 : 2; }

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (c == '\n') {
            out += "\\n";
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            constexpr std::string_view digits = "0123456789abcdef";
            out += "\\u{";
            out += digits[static_cast<unsigned char>(c) >> 4];
            out += digits[static_cast<unsigned char>(c) & 15];
            out += '}';
        } else {
            out += c;
        }
    }
    return out + '"';
}

struct Writer {
    std::string out;

    void write(const Value& value) {
        std::visit([this](const auto& data) { write(data); }, value.data);
    }
    void write(const Quantity& quantity) {
        out += to_text(quantity.value);
        if (quantity.is_angle) out += "deg";
    }
    void write(bool value) { out += value ? "true" : "false"; }
    void write(const std::string& text) { out += quoted(text); }
    void write(const Colour& colour) { out += to_text(colour); }
    void write(const Symbol& symbol) { out += symbol.name; }
    void write(const Vec& point) { out += "(" + to_text(point.x) + ", " + to_text(point.y) + ")"; }
    void write(const ValueList& list) {
        out += '[';
        for (std::size_t i = 0; i < list.items.size(); ++i) {
            if (i > 0) out += ", ";
            write(list.items[i]);
        }
        out += ']';
    }
    void write(const SymbolicCall& call) {
        if (is_operation(call)) return write_operation(call);
        out += call.name + "(";
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            if (i > 0) out += ", ";
            if (!call.arguments[i].name.empty()) out += call.arguments[i].name + ": ";
            write(call.arguments[i].value);
        }
        out += ')';
    }
    // In brackets what would bind otherwise without.
    void write_operation(const SymbolicCall& call) {
        for (std::size_t i = 0; i < call.arguments.size(); ++i) {
            const Value& operand = call.arguments[i].value;
            const auto* inner = std::get_if<SymbolicCall>(&operand.data);
            const int least_tier = i == 0 ? tier_of(call) : tier_of(call) + 1;
            const bool has_brackets = inner != nullptr && is_operation(*inner) && tier_of(*inner) < least_tier;
            if (i > 0) out += " " + call.name + " ";
            if (has_brackets) out += '(';
            write(operand);
            if (has_brackets) out += ')';
        }
    }
};

struct KindNamer {
    std::string_view operator()(const Quantity& quantity) const { return kind_of(quantity); }
    std::string_view operator()(bool) const { return "true or false"; }
    std::string_view operator()(const std::string&) const { return "a text"; }
    std::string_view operator()(const Colour&) const { return "a colour"; }
    std::string_view operator()(const Symbol&) const { return "a word"; }
    std::string_view operator()(const Vec&) const { return "a point"; }
    std::string_view operator()(const ValueList&) const { return "a list"; }
    std::string_view operator()(const SymbolicCall& call) const { return is_operation(call) ? "a shape" : "a call"; }
};

}  // namespace

bool is_operation(const SymbolicCall& call) { return is_sum_sign(call.name) || call.name == "*" || call.name == "&"; }

ValueSize size_of(const Value& root) {
    ValueSize size;
    std::vector<std::pair<const Value*, std::size_t>> open{{&root, 1}};
    while (!open.empty()) {
        const auto [value, depth] = open.back();
        open.pop_back();
        ++size.parts;
        size.depth = std::max(size.depth, depth);
        if (const auto* list = std::get_if<ValueList>(&value->data)) {
            for (const Value& item : list->items) open.emplace_back(&item, depth + 1);
        } else if (const auto* call = std::get_if<SymbolicCall>(&value->data)) {
            for (const NamedValue& argument : call->arguments) open.emplace_back(&argument.value, depth + 1);
        }
    }
    return size;
}

std::string to_text(const Value& value) {
    Writer writer;
    writer.write(value);
    return std::move(writer.out);
}

std::string plain_text(const Value& value) {
    const std::string* text = std::get_if<std::string>(&value.data);
    return text != nullptr ? *text : to_text(value);
}

std::string_view kind_of(const Value& value) { return std::visit(KindNamer{}, value.data); }

}  // namespace filigree
