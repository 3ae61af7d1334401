#include "FineParts.h"

#include <algorithm>
#include <numeric>

namespace frazil
{

FineParts::FineParts(const std::vector<FinePiece>& pieces, const LocalCells& cells)
{
    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    // Stable, so that the order of sums, and with it round-off, is the host's.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const FinePiece &p = pieces[a], &q = pieces[b];
        return p.coarseCell != q.coarseCell ? p.coarseCell < q.coarseCell : p.fineCell < q.fineCell;
    });
    const FinePiece* last = nullptr;
    for (const std::size_t n : order) {
        const FinePiece& piece = pieces[n];
        const bool newRow = !last || piece.coarseCell != last->coarseCell;
        if (newRow) {
            if (last)
                start_.push_back(parts_.size());
            coarseCell_.push_back(cells.local(piece.coarseCell));
        }
        if (newRow || piece.fineCell != last->fineCell) {
            parts_.push_back({piece.fineCell, piece.volume, piece.centroid});
        } else {
            FinePart& part = parts_.back();
            const double sum = part.volume + piece.volume;
            part.centroid += piece.volume / sum * (piece.centroid - part.centroid);
            part.volume = sum;
        }
        last = &piece;
    }
    if (last)
        start_.push_back(parts_.size());
}

} // namespace frazil
