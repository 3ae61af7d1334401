#include "cellBins.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelVector Foam::cellBins::binOf(const point& p) const
{
    labelVector bin;
    for (direction d = 0; d < 3; ++d)
    {
        const scalar at = (p[d] - box_.min()[d])*perBin_[d];
        bin[d] = at <= 0 ? 0 : label(min(at, scalar(n_[d] - 1)));
    }
    return bin;
}


template<class Visit>
void Foam::cellBins::forBins(const boundBox& box, const Visit& visit) const
{
    const labelVector lo(binOf(box.min()));
    const labelVector hi(binOf(box.max()));
    for (label k = lo.z(); k <= hi.z(); ++k)
    {
        for (label j = lo.y(); j <= hi.y(); ++j)
        {
            for (label i = lo.x(); i <= hi.x(); ++i)
            {
                visit(i + n_.x()*(j + n_.y()*k));
            }
        }
    }
}


Foam::List<Foam::boundBox> Foam::cellBins::measure(const polyMesh& mesh)
{
    List<boundBox> bounds(mesh.nCells(), boundBox(boundBox::invertedBox));
    const pointField& points = mesh.points();
    const vectorField& centres = mesh.cellCentres();
    auto add = [&](const label celli, const face& f)
    {
        for (const label pointi : f)
        {
            bounds[celli].add(points[pointi]);
            radius_[celli] =
                max(radius_[celli], mag(points[pointi] - centres[celli]));
        }
    };
    forAll(mesh.faceOwner(), facei)
    {
        add(mesh.faceOwner()[facei], mesh.faces()[facei]);
    }
    forAll(mesh.faceNeighbour(), facei)
    {
        add(mesh.faceNeighbour()[facei], mesh.faces()[facei]);
    }
    return bounds;
}


//- Counting sort: cells of bin b are cells_[start_[b]] to cells_[start_[b + 1] - 1]
void Foam::cellBins::sort(const List<boundBox>& bounds)
{
    labelList count(n_.x()*n_.y()*n_.z() + 1, Zero);
    for (const boundBox& box : bounds)
    {
        forBins(box, [&](const label bin) { ++count[bin + 1]; });
    }
    for (label bin = 1; bin < count.size(); ++bin)
    {
        count[bin] += count[bin - 1];
    }
    start_ = count;
    cells_.setSize(count.last());
    forAll(bounds, celli)
    {
        forBins
        (
            bounds[celli],
            [&](const label bin) { cells_[count[bin]++] = celli; }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellBins::cellBins(const polyMesh& mesh)
:
    box_(mesh.points(), false),
    n_(1, 1, 1),
    seen_(mesh.nCells(), -1),
    query_(0),
    radius_(mesh.nCells(), Zero)
{
    // About eight cells per bin where cells are of mean size
    const vector span(box_.span() + vector::uniform(VSMALL));
    const scalar width =
        2*cbrt(span.x()*span.y()*span.z()/max(mesh.nCells(), label(1)));
    for (direction d = 0; d < 3; ++d)
    {
        n_[d] = max(label(1), min(label(1000), label(span[d]/width)));
        perBin_[d] = n_[d]/span[d];
    }
    sort(measure(mesh));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellBins::find(const boundBox& box, DynamicList<label>& found)
{
    found.clear();
    if (seen_.empty() || !box_.overlaps(box))
    {
        return;
    }

    ++query_;
    forBins
    (
        box,
        [&](const label bin)
        {
            for (label at = start_[bin]; at < start_[bin + 1]; ++at)
            {
                const label celli = cells_[at];
                if (seen_[celli] != query_)
                {
                    seen_[celli] = query_;
                    found.append(celli);
                }
            }
        }
    );
}


// ************************************************************************* //
