#include "session/embed.h"

#include <cmath>
#include <map>
#include <mutex>

#include "engines/tangle/derive.h"
#include "engines/tangle/draw.h"
#include "scene/arrange.h"

namespace filigree {
namespace {

bool is_identity(const Transform& transform) { return transform == Transform{}; }

std::uint64_t memory_of(const Drawing& drawing) {
    std::uint64_t bytes = drawing.shapes.capacity() * sizeof(DrawnShape);
    for (const auto& geometry : drawing.geometry) bytes += geometry->memory_bytes();
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

// The documents that one document may embed, with what is read of them once.
class Embedder {
public:
    Embedder(const OpenedDocument& opened, const Job& job) : opened_(opened), job_(job) {
        for (const EmbeddedDocument& inner : opened.embedded) {
            inner_.push_back(inner.opened ? embed_function(*inner.opened, job) : EmbedFunction());
        }
    }

    Result<std::shared_ptr<const Embedded>> embed(const EmbedRequest& request) {
        const std::size_t which = find(request);
        const EmbeddedDocument& document = opened_.embedded[which];
        auto run = std::make_shared<EmbeddedTangle>();
        run->opened = document.opened;
        run->root = request.site.root;
        const auto failed = [&](Diagnostics reasons) { return at_first_source(std::move(reasons), *document.opened); };

        Result<std::shared_ptr<const CheckedDocument>> checked = read(document, request);
        if (!checked) return failed(std::move(checked).diagnostics());
        run->checked = *checked;
        const Settings& settings = *run->checked->settings;
        Result<PlaneStart> start =
            make_plane_start(settings, document.opened->document, document.opened->inputs, request.site, &request.host);
        if (!start) {
            const std::string& code = start.diagnostics().front().code;
            if (code == "start.too-small" || code == "start.empty") return std::shared_ptr<const Embedded>();
            return failed(std::move(start).diagnostics());
        }
        run->start = std::move(*start);

        tangle::DeriveOptions options;
        options.site = request.site;
        options.embed = inner_[which];
        options.element_budget = request.element_budget;
        SerialExecutor serial;
        Result<tangle::Tangle> tangle =
            tangle::derive(*run->checked->grammar, run->start, settings, document.opened->document, options, serial,
                           {job_.cancel_flag, {}});
        if (!tangle) return failed(std::move(tangle).diagnostics());
        run->tangle = std::move(*tangle);
        Result<tangle::Picture> picture =
            tangle::draw(run->tangle, *run->checked->grammar, settings, document.opened->document,
                         {tangle::ColourBy::style, request.site});
        if (!picture) return failed(std::move(picture).diagnostics());
        return finished(std::move(run), std::move(*picture), request);
    }

private:
    std::size_t find(const EmbedRequest& request) const {
        for (std::size_t i = 0; i < opened_.embedded.size(); ++i) {
            const EmbeddableDocument& info = opened_.embedded[i].info;
            if (info.is_file == request.is_file && info.name == request.document) return i;
        }
        return 0;  // the grammar was read with these documents, so one has the name
    }

    // Settings and grammar at this site. They are the same at all of them unless something is drawn or given.
    Result<std::shared_ptr<const CheckedDocument>> read(const EmbeddedDocument& document, const EmbedRequest& request) {
        const bool may_be_shared = request.site.given.empty() && !request.site.host.state;
        if (may_be_shared) {
            const std::lock_guard lock(mutex_);
            const auto known = read_once_.find(document.opened.get());
            if (known != read_once_.end()) return known->second;
        }
        auto checked = std::make_shared<CheckedDocument>();
        Result<Settings> settings = read_settings(document.opened->document, request.site);
        if (!settings) return std::move(settings).diagnostics();
        checked->settings = std::move(*settings);
        Result<tangle::Grammar> grammar =
            tangle::read_grammar(*checked->settings, document.opened->document,
                                 start_tags(*document.opened, *checked->settings), embeddable(*document.opened));
        if (!grammar) return std::move(grammar).diagnostics();
        checked->grammar = std::move(*grammar);
        if (may_be_shared && checked->settings->definitions.rows.empty()) {
            const std::lock_guard lock(mutex_);
            read_once_.emplace(document.opened.get(), checked);
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
            const Canvas& canvas = picture.drawing.canvas;
            const Page page{PageStatement::Kind::size, canvas.size.x, canvas.size.y, {}, false};
            const Vec centre = canvas.origin + 0.5 * canvas.size;
            run->to_host = compose(page_onto(page, bounds(request.host), "cover"), translation(-1 * centre));
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
    const Job job_;
    std::vector<EmbedFunction> inner_;  // of each document that it may embed
    std::mutex mutex_;
    std::map<const OpenedDocument*, std::shared_ptr<const CheckedDocument>> read_once_;  // looked up only
};

}  // namespace

void for_each_embedded(const tangle::Tangle& tangle, const std::function<void(const EmbeddedTangle& inner)>& visit) {
    for (const tangle::Step& step : tangle.steps) {
        for (const auto& embedded : step.embedded) {
            if (!embedded) continue;
            const auto& inner = static_cast<const EmbeddedTangle&>(*embedded->run);
            visit(inner);
            for_each_embedded(inner.tangle, visit);
        }
    }
}

EmbedFunction embed_function(const OpenedDocument& opened, const Job& job) {
    if (opened.embedded.empty()) return {};
    auto embedder = std::make_shared<Embedder>(opened, job);
    return [embedder](const EmbedRequest& request) { return embedder->embed(request); };
}

}  // namespace filigree
