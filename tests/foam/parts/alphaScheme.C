// open/alphaScheme.H and open/faceMax.H: a linear velocity, whose symmetric gradient is the same everywhere
#include "parts.H"
#include "alphaScheme.H"
#include "faceMax.H"
#include "immiscibleIncompressibleTwoPhaseMixture.H"

namespace Foam
{

namespace
{

constexpr scalar exact = 1e-12;
constexpr scalar cAlpha = 0.7;  // as fvSolution has it


//- cα [(1 - ic)|φ|/|S| + ic |U|] + sc |d·sym ∇U|, zero on the boundary
scalarField expectedCompression
(
    const plainMesh& mesh,
    const scalarField& speed,
    const knownVelocity& u,
    const scalar ic,
    const scalar sc
)
{
    scalarField result(mesh.faces().size(), Zero);
    forAll(result, facei)
    {
        const plainFace& f = mesh.faces()[facei];
        const scalar through = mag(u(f.centre) & f.n);
        const scalar shear = f.distance*mag(f.n & symm(u.A));
        const scalar all = cAlpha*((1 - ic)*through + ic*f.linear(speed)) + sc*shear;
        result[facei] = f.boundary ? 0 : all;
    }
    return result;
}

} // End anonymous namespace


void testCompression(const fvMesh& mesh)
{
    const knownVelocity u(linearVelocity());
    const volVectorField U(fieldOf<vector>("U", mesh, dimVelocity, u));
    const surfaceScalarField phi(fluxOf(mesh, u));
    const immiscibleIncompressibleTwoPhaseMixture mixture(U, phi);
    const plainMesh plain(mesh);
    const scalarField speed(plain.cells(mag(U.primitiveField())()));
    for (const scalar ic : {0.0, 0.3, 1.0})
    {
        for (const scalar sc : {0.0, 0.25})
        {
            compare("compression, ic " + std::to_string(ic) + ", sc " + std::to_string(sc),
                plain.onFaces(compressionVelocity(mixture, U, phi, ic, sc)()),
                expectedCompression(plain, speed, u, ic, sc), exact);
        }
    }
}


void printOffCentring(Time& runTime, const fvMesh& mesh, const label nSubCycles)
{
    ++runTime;
    Info<< "off-centring " << alphaOffCentring(mesh, nSubCycles, false) << ' '
        << alphaOffCentring(mesh, nSubCycles, true);
    ++runTime;
    Info<< ' ' << alphaOffCentring(mesh, nSubCycles, false) << endl;
}


//- The greatest of the two cells; on the boundary the cell's own, whatever the patch holds
void testFaceMax(const fvMesh& mesh)
{
    const knownScalar f{2, vector(30, -20, 10)};
    const plainMesh plain(mesh);
    const volScalarField field(fieldOf<scalar>("f", mesh, dimless, f));
    const scalarField wide(plain.cells(field.primitiveField()));
    scalarField expected(mesh.nFaces());
    forAll(expected, facei)
    {
        const plainFace& face = plain.faces()[facei];
        const bool uphill = (f.gradient & face.n) > 0 && !face.boundary;
        expected[facei] = wide[uphill ? face.neighbour : face.owner];
    }
    compare("greatest of a face's cells", plain.onFaces(faceMax(field)()), expected, 0);
}

} // End namespace Foam
