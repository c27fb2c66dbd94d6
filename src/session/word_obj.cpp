#include "session/word_obj.h"

namespace filigree {

Result<ObjFiles> word_obj(const OpenedDocument& opened, const CheckedDocument& checked, const WordRun& word,
                          const std::string& materials_file) {
    const rewriting::Derivation& derivation = word.derivation;
    const Result<rewriting::WordSolid> solid = rewriting::draw_solid(derivation, *checked.draw_rules, *checked.settings,
                                                                     opened.document, {{}, checked.shapes.get(), {}});
    if (!solid) return solid.diagnostics();
    ObjOptions options;
    options.materials_file = materials_file;
    options.group_of = [&](Key element) {
        const auto place = solid->symbols.find(element.value);
        if (place == solid->symbols.end()) return std::string("word");
        const char32_t letter = derivation.alphabet[derivation.word.symbols[place->second]].letter;
        return rewriting::to_utf8(std::u32string(1, letter)) + "_" + std::to_string(place->second);
    };
    return to_obj(solid->mesh, solid->materials, options);
}

}  // namespace filigree
