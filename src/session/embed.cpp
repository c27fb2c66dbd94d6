#include "session/embed.h"

#include <cmath>
#include <map>
#include <mutex>
#include <optional>

#include "derivation/symmetric_drawing.h"
#include "engines/tangle/derive.h"
#include "engines/tangle/draw.h"
#include "scene/arrange.h"

namespace filigree {
namespace {

bool is_identity(const Transform& transform) { return transform == Transform{}; }

std::uint64_t memory_of(const Drawing& drawing) {
    std::uint64_t bytes = drawing.shapes.capacity() * sizeof(DrawnShape);
    for (const auto& geometry : drawing.geometry) bytes += geometry->memory_bytes();
    for (const Path& curve : drawing.curves) {
        bytes += sizeof(Path) + curve.verbs.capacity() + curve.points.capacity() * sizeof(Vec);
    }
    return bytes;
}

std::uint64_t leaves_of(const tangle::Tangle& tangle) {
    std::uint64_t count = 0;
    for (const tangle::Group& group : tangle.groups) {
        if (group.consumer == tangle::none) count += group.shapes.size();
    }
    for (const tangle::Step& step : tangle.steps) {
        for (const auto& embedded : step.embedded) count += embedded ? embedded->elements : 0;
    }
    return count;
}

// What the embedders of one outermost document share: each document that is the same at all its sites is read once.
struct SharedDocuments {
    std::mutex mutex;
    std::map<const OpenedDocument*, std::shared_ptr<const CheckedDocument>> read_once;  // looked up only
};

// The documents that one document may embed, with functions for those that they embed in turn, in the same order.
class Embedder {
public:
    Embedder(const OpenedDocument& opened, bool lists_choices, const Job& job, std::shared_ptr<SharedDocuments> shared,
             std::vector<EmbedFunction> inner)
        : opened_(opened),
          lists_choices_(lists_choices),
          job_(job),
          shared_(std::move(shared)),
          inner_(std::move(inner)) {}

    Result<std::shared_ptr<const Embedded>> embed(const EmbedRequest& request) {
        const std::optional<std::size_t> which = find(request);
        if (!which) return unknown(request);
        const EmbeddedDocument& document = opened_.embedded[*which];
        // As places of the sources from those of `opened_` on: whoever derives that one shifts them further.
        const auto failed = [&](Diagnostics reasons) {
            for (Diagnostic& reason : reasons) {
                if (reason.span.file == SourceSpan::no_file) continue;
                reason.span.file += document.opened->first_source - opened_.first_source;
            }
            return reasons;
        };

        Result<std::shared_ptr<const CheckedDocument>> checked = read(document, request);
        if (!checked) return failed(std::move(checked).diagnostics());
        Result<std::shared_ptr<const Embedded>> embedded =
            (*checked)->words    ? embedded_word(document, *checked, request)
            : (*checked)->design ? embedded_design(document, *checked, request)
                                 : embedded_tangle(*which, *checked, request);
        if (!embedded) return failed(std::move(embedded).diagnostics());
        return embedded;
    }

private:
    Result<std::shared_ptr<const Embedded>> embedded_tangle(std::size_t which,
                                                            std::shared_ptr<const CheckedDocument> checked,
                                                            const EmbedRequest& request) {
        const EmbeddedDocument& document = opened_.embedded[which];
        auto run = std::make_shared<EmbeddedTangle>();
        run->opened = document.opened;
        run->checked = std::move(checked);
        run->root = request.site.root;
        const Settings& settings = *run->checked->settings;
        Result<PlaneStart> start =
            make_plane_start(settings, document.opened->document, *run->checked->shapes, request.site, &request.host);
        if (!start) {
            const std::string& code = start.diagnostics().front().code;
            if (code == "start.too-small" || code == "start.empty") return std::shared_ptr<const Embedded>();
            return std::move(start).diagnostics();
        }
        run->start = std::move(*start);

        tangle::DeriveOptions options;
        options.site = request.site;
        options.embed = inner_[which];
        options.shapes = run->checked->shapes.get();
        options.element_budget = request.element_budget;
        SerialExecutor serial;
        Result<tangle::Tangle> tangle =
            tangle::derive(*run->checked->grammar, run->start, settings, document.opened->document, options, serial,
                           {job_.cancel_flag, {}});
        if (!tangle) return std::move(tangle).diagnostics();
        run->tangle = std::move(*tangle);
        Result<tangle::Picture> picture =
            tangle::draw(run->tangle, *run->checked->grammar, settings, document.opened->document,
                         {tangle::ColourBy::style, request.site, {job_.cancel_flag, {}}});
        if (!picture) return std::move(picture).diagnostics();
        if (run->start.symmetry) {
            Result<Drawing> all = repeated_over_page(picture->drawing, run->start, settings, {job_.cancel_flag, {}});
            if (!all) return std::move(all).diagnostics();
            picture->drawing = std::move(*all);
        }
        return finished(std::move(run), std::move(*picture), request);
    }

    // A word fits into the shape's box, and what reaches beyond the shape is cut off.
    Result<std::shared_ptr<const Embedded>> embedded_word(const EmbeddedDocument& document,
                                                          std::shared_ptr<const CheckedDocument> checked,
                                                          const EmbedRequest& request) {
        SerialExecutor serial;
        WordOptions options;
        options.site = request.site;
        options.most_elements = request.element_budget;
        options.records_choices = lists_choices_;
        Result<DrawnWord> drawn = draw_word(*document.opened, *checked, options, serial, {job_.cancel_flag, {}});
        if (!drawn) return std::move(drawn).diagnostics();
        auto run = std::make_shared<EmbeddedWord>();
        run->opened = document.opened;
        run->checked = std::move(checked);
        run->root = request.site.root;
        run->word = std::move(drawn->run);
        std::vector<std::uint8_t> met;
        if (const auto& choices = run->word.derivation.choices) met = choices->met();
        return contained(std::move(run), std::move(met), drawn->drawing, request);
    }

    // Likewise a design.
    Result<std::shared_ptr<const Embedded>> embedded_design(const EmbeddedDocument& document,
                                                            std::shared_ptr<const CheckedDocument> checked,
                                                            const EmbedRequest& request) {
        Result<DrawnDesign> drawn = draw_design(*document.opened, *checked, {{}, request.site}, {job_.cancel_flag, {}});
        if (!drawn) return std::move(drawn).diagnostics();
        auto run = std::make_shared<EmbeddedDesign>();
        run->opened = document.opened;
        run->checked = std::move(checked);
        run->root = request.site.root;
        run->design = std::move(drawn->run);
        std::vector<std::uint8_t> met = run->design.derivation.met;
        return contained(std::move(run), std::move(met), drawn->drawing, request);
    }

    // A drawing that fits into the shape's box; what reaches beyond the shape is cut off.
    static std::shared_ptr<const Embedded> contained(std::shared_ptr<EmbeddedPart> run, std::vector<std::uint8_t> met,
                                                     const Drawing& drawing, const EmbedRequest& request) {
        auto embedded = std::make_shared<Embedded>();
        embedded->met = std::move(met);
        embedded->elements = drawing.shapes.size();
        run->to_host = canvas_onto(drawing.canvas, request.host, "contain");
        Polygons clip;
        clip.add(request.host);
        Placement placement;
        placement.clip = &clip;
        placement.transform = run->to_host;
        placement.pen_scale = std::sqrt(std::abs(determinant(run->to_host)));
        place_drawing(embedded->drawing, drawing, placement);
        embedded->memory_bytes = memory_of(embedded->drawing);
        embedded->run = std::move(run);
        return embedded;
    }

    // The whole picture, laid over the shape's box as in host(fit: ...).
    static Transform canvas_onto(const Canvas& canvas, PolygonView host, std::string_view fit) {
        const Page page{PageStatement::Kind::size, canvas.size.x, canvas.size.y, {}, false};
        const Vec centre = canvas.origin + 0.5 * canvas.size;
        return compose(page_onto(page, bounds(host), fit), translation(-1 * centre));
    }

    // None where the value is no name of a document, as a preset may say it.
    std::optional<std::size_t> find(const EmbedRequest& request) const {
        for (std::size_t i = 0; i < opened_.embedded.size(); ++i) {
            const EmbeddedDocument& one = opened_.embedded[i];
            const bool is_this = one.info.is_file == request.is_file && one.info.name == request.document;
            if (is_this && one.opened) return i;
        }
        return std::nullopt;
    }

    // Without a place: the caller knows the rule.
    static Diagnostic unknown(const EmbedRequest& request) {
        const std::string name = "'" + std::string(request.document) + "'";
        if (!request.is_file) return error("embed.unknown-system", "there is no system " + name);
        return error("embed.missing", "the document " + name + " cannot be read", {},
                     {"files are opened where a rule names them"});
    }

    // Settings and grammar at this site. They are the same at all of them unless something is drawn or given.
    Result<std::shared_ptr<const CheckedDocument>> read(const EmbeddedDocument& document, const EmbedRequest& request) {
        const bool may_be_shared = request.site.given.empty() && !request.site.host.state;
        if (may_be_shared) {
            const std::lock_guard lock(shared_->mutex);
            const auto known = shared_->read_once.find(document.opened.get());
            if (known != shared_->read_once.end()) return known->second;
        }
        auto checked = std::make_shared<CheckedDocument>();
        Result<Settings> settings = read_settings(document.opened->document, request.site);
        if (!settings) return std::move(settings).diagnostics();
        checked->settings = std::move(*settings);
        checked->shapes = std::make_shared<const ShapeSource>(document.opened->inputs, checked->settings->resolution);
        if (checked->settings->engine == "rewriting") {
            Diagnostics problems = read_words(*document.opened, *checked);
            if (has_errors(problems)) return problems;
        } else if (checked->settings->engine == "shape") {
            Diagnostics problems = read_design(*document.opened, *checked);
            if (has_errors(problems)) return problems;
        } else {
            Result<tangle::Grammar> grammar =
                tangle::read_grammar(*checked->settings, document.opened->document,
                                     start_tags(*document.opened, *checked->settings), embeddable(*document.opened));
            if (!grammar) return std::move(grammar).diagnostics();
            checked->grammar = std::move(*grammar);
        }
        if (may_be_shared && checked->settings->definitions.rows.empty()) {
            const std::lock_guard lock(shared_->mutex);
            shared_->read_once.emplace(document.opened.get(), checked);
        }
        return std::shared_ptr<const CheckedDocument>(std::move(checked));
    }

    // The drawing in the host's coordinates: where no start takes the host's shape, as a picture that covers it. What
    // may reach beyond the shape is cut off at its border.
    static std::shared_ptr<const Embedded> finished(std::shared_ptr<EmbeddedTangle> run, tangle::Picture picture,
                                                    const EmbedRequest& request) {
        auto embedded = std::make_shared<Embedded>();
        embedded->elements = leaves_of(run->tangle);
        embedded->met = run->tangle.met;
        for (std::size_t i = 0; i < embedded->met.size() && i < picture.met.size(); ++i) {
            embedded->met[i] = embedded->met[i] | picture.met[i];
        }
        run->to_host = run->start.to_host;
        Placement placement;
        Polygons clip;
        if (!run->start.in_host) {
            run->to_host = canvas_onto(picture.drawing.canvas, request.host, "cover");
        }
        const bool is_clipped = !run->start.in_host || run->start.leaves_host;
        if (is_clipped) {
            clip.add(request.host);
            placement.clip = &clip;
        }
        if (!is_clipped && is_identity(run->to_host)) {
            embedded->drawing = std::move(picture.drawing);
        } else {
            placement.transform = run->to_host;
            placement.pen_scale = std::sqrt(std::abs(determinant(run->to_host)));
            place_drawing(embedded->drawing, picture.drawing, placement);
        }
        picture.drawing = {};
        run->picture = std::move(picture);
        embedded->memory_bytes = memory_of(embedded->drawing);
        embedded->run = std::move(run);
        return embedded;
    }

    const OpenedDocument& opened_;
    const bool lists_choices_;
    const Job job_;
    std::shared_ptr<SharedDocuments> shared_;
    std::vector<EmbedFunction> inner_;
};

// Makes one function for each document, however many ways lead to it.
class EmbedderMaker {
public:
    EmbedderMaker(bool lists_choices, const Job& job) : lists_choices_(lists_choices), job_(job) {}

    EmbedFunction make(const OpenedDocument& opened) {
        if (opened.embedded.empty()) return {};
        const auto known = made_.find(&opened);
        if (known != made_.end()) return known->second;
        std::vector<EmbedFunction> inner;
        for (const EmbeddedDocument& document : opened.embedded) {
            inner.push_back(document.opened ? make(*document.opened) : EmbedFunction());
        }
        auto embedder = std::make_shared<Embedder>(opened, lists_choices_, job_, shared_, std::move(inner));
        EmbedFunction function = [embedder](const EmbedRequest& request) { return embedder->embed(request); };
        made_.emplace(&opened, function);
        return function;
    }

private:
    const bool lists_choices_;
    const Job& job_;
    std::shared_ptr<SharedDocuments> shared_ = std::make_shared<SharedDocuments>();
    std::map<const OpenedDocument*, EmbedFunction> made_;  // looked up only
};

}  // namespace

const EmbeddedTangle* tangle_in(const Embedded& embedded) {
    return dynamic_cast<const EmbeddedTangle*>(embedded.run.get());
}
const EmbeddedWord* word_in(const Embedded& embedded) { return dynamic_cast<const EmbeddedWord*>(embedded.run.get()); }
const EmbeddedDesign* design_in(const Embedded& embedded) {
    return dynamic_cast<const EmbeddedDesign*>(embedded.run.get());
}

void for_each_embedded(const tangle::Tangle& tangle, const std::function<void(const EmbeddedTangle& inner)>& visit) {
    for (const tangle::Step& step : tangle.steps) {
        for (const auto& embedded : step.embedded) {
            if (!embedded) continue;
            const EmbeddedTangle* inner = tangle_in(*embedded);
            if (inner == nullptr) continue;
            visit(*inner);
            for_each_embedded(inner->tangle, visit);
        }
    }
}

EmbedFunction embed_function(const OpenedDocument& opened, bool lists_choices, const Job& job) {
    return EmbedderMaker(lists_choices, job).make(opened);
}

}  // namespace filigree
