#include "session/edit_document.h"

#include "language/edit_presets.h"
#include "session/check.h"

namespace filigree {

std::string to_text(const DocumentEdit& edit) {
    using Kind = DocumentEdit::Kind;
    switch (edit.kind) {
        case Kind::set:
            return "set " + edit.path + " = " + edit.value;
        case Kind::set_default:
            return "default " + edit.path + " = " + edit.value;
        case Kind::unset:
            return "remove set " + edit.path;
        case Kind::keep:
            return "keep " + edit.path;
        case Kind::unkeep:
            return "remove keep " + edit.path;
        case Kind::reroll:
            return "reroll " + edit.path + (edit.times == 1 ? "" : " x " + std::to_string(edit.times));
        case Kind::apply: {
            std::string text = "apply " + edit.value + " to ";
            for (std::size_t i = 0; i < edit.targets.size(); ++i) text += (i == 0 ? "" : ", ") + edit.targets[i];
            return text + (edit.outputs.empty() ? "" : " -> " + edit.outputs);
        }
    }
    return "";
}

Result<std::string> edited_text(const Document& document, const DocumentEdit& edit) {
    using Kind = DocumentEdit::Kind;
    switch (edit.kind) {
        case Kind::set:
            return with_preset(document, edit.path, edit.value);
        case Kind::set_default:
            return with_default(document, edit.path, edit.value);
        case Kind::unset:
            return without_preset(document, edit.path);
        case Kind::keep:
            return with_keep(document, edit.path);
        case Kind::unkeep:
            return without_keep(document, edit.path);
        case Kind::reroll:
            return with_reroll(document, edit.path, edit.times);
        case Kind::apply:
            return with_apply(document, edit.value, edit.targets, edit.outputs);
    }
    return document.text();
}

Result<OpenedDocument> edited(const OpenedDocument& opened, const DocumentEdit& edit) {
    Result<std::string> text = edited_text(opened.document, edit);
    if (!text) {
        // Their places are in what was given, not in the document.
        Diagnostics reasons = std::move(text).diagnostics();
        for (Diagnostic& reason : reasons) {
            reason.span = {};
            reason.hints.push_back("the edit is: " + to_text(edit));
        }
        return reasons;
    }
    OpenedDocument again = reopened(opened, std::move(*text));
    const CheckedDocument checked = check_document(again);
    if (!has_errors(checked.diagnostics)) return again;
    Diagnostics errors;
    for (const Diagnostic& one : checked.diagnostics) {
        if (one.severity != Severity::error) continue;
        errors.push_back(one);
        // The places are in the new text, which is not kept.
        errors.back().span = {};
        errors.back().hints.push_back("the edit is: " + to_text(edit));
    }
    return errors;
}

}  // namespace filigree
