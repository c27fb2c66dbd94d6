#include "space/rejoin.h"

#include <algorithm>

namespace filigree {
namespace {

constexpr std::size_t most_tests = 2000;  // for one part

class Rejoiner {
public:
    Rejoiner(const Pieces& pieces, std::span<const std::uint32_t> order, const PictureHulls& hulls)
        : pieces_(pieces),
          hulls_(hulls),
          order_(order.begin(), order.end()),
          place_of_(pieces.pieces.size(), no_piece),
          grid_(hulls.boxes, order) {
        for (std::uint32_t place = 0; place < order_.size(); ++place) place_of_[order_[place]] = place;
    }

    // The last cut first, so that parts are whole before what they are parts of.
    std::vector<std::uint32_t> rejoin() && {
        std::vector<std::uint32_t> first_part(pieces_.pieces.size(), no_piece), next_part = first_part;
        for (auto i = static_cast<std::uint32_t>(pieces_.pieces.size()); i-- > 0;) {
            const std::uint32_t parent = pieces_.pieces[i].parent;
            if (parent == no_piece) continue;
            next_part[i] = first_part[parent];
            first_part[parent] = i;
        }
        for (auto parent = static_cast<std::uint32_t>(pieces_.pieces.size()); parent-- > 0;) {
            parts_.clear();
            for (std::uint32_t part = first_part[parent]; part != no_piece; part = next_part[part]) {
                parts_.push_back(part);
            }
            if (!parts_.empty()) join(parent);
        }
        std::erase(order_, no_piece);
        return std::move(order_);
    }

private:
    void join(std::uint32_t parent) {
        std::uint32_t earliest = no_piece, latest = 0;
        for (const std::uint32_t part : parts_) {
            if (place_of_[part] == no_piece) return;  // is in parts itself
            earliest = std::min(earliest, place_of_[part]);
            latest = std::max(latest, place_of_[part]);
        }
        for (const std::uint32_t place : {earliest, latest}) {
            const auto may = [&](std::uint32_t part) { return may_move(part, place); };
            if (!std::all_of(parts_.begin(), parts_.end(), may)) continue;
            for (const std::uint32_t part : parts_) {
                order_[place_of_[part]] = no_piece;
                place_of_[part] = no_piece;
            }
            order_[place] = parent;
            place_of_[parent] = place;
            grid_.add(hulls_.boxes[parent], place);
            return;
        }
    }

    bool may_move(std::uint32_t part, std::uint32_t place) const {
        const auto [first, last] = std::minmax(place, place_of_[part]);
        std::size_t tests = 0;
        return grid_.visit_between(hulls_.boxes[part], first, last, [&](std::uint32_t between) {
            const std::uint32_t other = order_[between];
            return ++tests <= most_tests &&
                   (other == no_piece || pieces_.pieces[other].parent == pieces_.pieces[part].parent ||
                    !overlap(hulls_.boxes[part], hulls_.boxes[other]) || are_apart(hulls_[part], hulls_[other]));
        });
    }

    const Pieces& pieces_;
    const PictureHulls& hulls_;
    std::vector<std::uint32_t> order_;     // no_piece where a part was
    std::vector<std::uint32_t> place_of_;  // of what is in the order
    std::vector<std::uint32_t> parts_;
    OrderGrid grid_;
};

}  // namespace

std::vector<std::uint32_t> rejoined(const Pieces& pieces, std::span<const std::uint32_t> order,
                                    const PictureHulls& hulls) {
    return Rejoiner(pieces, order, hulls).rejoin();
}

}  // namespace filigree
