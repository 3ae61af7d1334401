// bodies/bodyCellSize.H: on a graded mesh, where every cell has another size along each edge
#include "parts.H"
#include "bodyCellSize.H"
#include "couplingSettings.H"

namespace Foam
{

namespace
{

constexpr scalar exact = 1e-12;


scalar edge(const fvMesh& mesh, const label celli)
{
    return std::cbrt(mesh.V()[celli]);
}


//- Least edge of the cells whose centre is in the box, of all if none is
scalar finestIn(const fvMesh& mesh, const boundBox& box)
{
    scalar inside = GREAT;
    scalar all = GREAT;
    forAll(mesh.C(), celli)
    {
        all = min(all, edge(mesh, celli));
        inside = box.contains(mesh.C()[celli]) ? min(inside, edge(mesh, celli)) : inside;
    }
    reduce(inside, minOp<scalar>());
    reduce(all, minOp<scalar>());
    return inside < GREAT ? inside : all;
}


//- A body of which the case says where its box is, moved by shift
void testCellSize(const fvMesh& mesh, const word& name, const vector& shift)
{
    const IOdictionary dict(IOobject("couplingProperties", mesh.time().constant(), mesh, IOobject::MUST_READ));
    const dictionary& entry = dict.subDict("boxes").subDict(name);
    const boundBox box(entry.get<point>("min") + shift, entry.get<point>("max") + shift);
    const frazil::Settings settings(couplingSettings(dict.subDict("bodies"), "bodies"));
    const immersedBody body(name, settings.sub(name), mesh.time().rootPath()/mesh.time().globalCaseName());
    frazil::BodyState state(body.asLoaded());
    state.centre = toVec3(toVector(state.centre) + shift);
    const placedBody placed(body, bodyPose(state, body.centroid()));
    compare("cell size at " + name, cellSizeAt(mesh, placed), finestIn(mesh, box), exact);
}


//- Cells 0, 1, 2 of each rank open, half closed, closed: only the second is cut
void testFinestCut(const fvMesh& mesh)
{
    bodyCut cut;
    for (label celli = 0; celli < 3; ++celli)
    {
        cut.cells.append(celli);
        cut.share.append(0.5*celli);
    }
    compare("finest cut", finestCut(mesh, cut), returnReduce(edge(mesh, 1), minOp<scalar>()), exact);
    cut.share[1] = 1;
    compare("finest cut of none", finestCut(mesh, cut), GREAT, 0);
}


//- The cell that the body crosses fastest decides: not the fastest point, nor the smallest cell
void testBodyDeltaT(const fvMesh& mesh)
{
    const knownVelocity u(linearVelocity());
    scalar rate = 0;
    forAll(mesh.C(), celli)
    {
        rate = max(rate, mag(u(mesh.C()[celli]))/edge(mesh, celli));
    }
    reduce(rate, maxOp<scalar>());
    compare("time step of a body", bodyDeltaT(fieldOf<vector>("Ub", mesh, dimVelocity, u), 0.3), 0.3/rate, exact);

    const knownVelocity rest{Zero, Zero, Zero};
    require(bodyDeltaT(fieldOf<vector>("Ub", mesh, dimVelocity, rest), 0.3) > GREAT, "a body at rest sets no limit");
}

} // End anonymous namespace


void testBodyCellSize(const fvMesh& mesh)
{
    testCellSize(mesh, "large", Zero);
    testCellSize(mesh, "large", vector(0.006, 0.003, -0.002));
    testCellSize(mesh, "tiny", Zero);
    testFinestCut(mesh);
    testBodyDeltaT(mesh);
}

} // End namespace Foam
