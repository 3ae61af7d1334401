#include "openReference.H"

namespace Foam
{

// * * * * * * * * * * * * * * * * * * Cells * * * * * * * * * * * * * * * * //

bool openReference::solid(const label celli) const
{
    return epsilonStart(celli) < closedBelow && epsilon(celli) < closedBelow;
}


scalarField openReference::epsilonStart() const
{
    scalarField result(mesh_.nCells());
    forAll(result, celli)
    {
        result[celli] = epsilonStart(celli);
    }
    return result;
}


scalarField openReference::epsilon() const
{
    scalarField result(mesh_.nCells());
    forAll(result, celli)
    {
        result[celli] = epsilon(celli);
    }
    return result;
}


boolList openReference::solid() const
{
    boolList result(mesh_.nCells(), false);
    forAll(result, celli)
    {
        result[celli] = solid(celli);
    }
    return result;
}


boolList openReference::closed() const
{
    boolList result(mesh_.nCells(), false);
    forAll(result, celli)
    {
        result[celli] = epsilon(celli) < closedBelow;
    }
    return result;
}


scalarField openReference::sweptVolume() const
{
    scalarField result(mesh_.nCells());
    forAll(result, celli)
    {
        result[celli] = s_.V[celli]*(epsilonStart(celli) - epsilon(celli))/s_.deltaT;
    }
    return result;
}


scalarField openReference::cuttingDemand() const
{
    scalarField rigid(mesh_.faces().size());
    forAll(rigid, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        rigid[facei] = (1 - s_.theta[facei])*(f.linear(s_.Ub) & f.S);
    }
    scalarField result(mesh_.outflow(rigid));
    forAll(result, celli)
    {
        const scalar covered = s_.V[celli]*(s_.gamma[celli] - s_.gammaStart[celli])/s_.deltaT;
        result[celli] = solid(celli) ? 0 : s_.fluid[celli]*(covered + result[celli]);
    }
    return result;
}


vectorField openReference::reconstruct(const scalarField& flux) const
{
    vectorField result(mesh_.nCells());
    forAll(result, celli)
    {
        tensor matrix(Zero);
        vector sum(Zero);
        for (const label facei : mesh_.facesOf(celli))
        {
            const plainFace& f = mesh_.faces()[facei];
            matrix += max(s_.theta[facei], 0.01)*f.n*f.S;
            sum += s_.theta[facei]*flux[facei]*f.n;
        }
        result[celli] = inv(matrix) & sum;
    }
    return result;
}


scalar openReference::courantNumber(const scalarField& flux) const
{
    scalar largest = 0;
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        scalar through = 0;
        for (const label facei : mesh_.facesOf(celli))
        {
            through += mag(flux[facei]);
        }
        largest = max(largest, 0.5*through*s_.deltaT/(s_.fluid[celli]*s_.V[celli]));
    }
    return returnReduce(largest, maxOp<scalar>());
}


template<class Type>
void openReference::continueByOneLayer(Field<Type>& own, const boolList& closed) const
{
    const Field<Type> wide(mesh_.cells(own));
    forAll(own, celli)
    {
        Type sum(Zero);
        scalar weight = 0;
        for (const label facei : mesh_.facesOf(celli))
        {
            const plainFace& f = mesh_.faces()[facei];
            const bool owns = f.owner == celli;
            const scalar outward = (owns ? f.S : -f.S) & s_.normal[celli];
            if (!f.boundary && outward > 0)
            {
                sum += outward*wide[owns ? f.neighbour : f.owner];
                weight += outward;
            }
        }
        if (closed[celli] && weight > 0)
        {
            own[celli] = sum/weight;
        }
    }
}


template<class Type>
Field<Type> openReference::continued(const Field<Type>& own, const boolList& closed) const
{
    Field<Type> result(own);
    continueByOneLayer(result, closed);
    continueByOneLayer(result, closed);
    continueByOneLayer(result, closed);
    return result;
}


template scalarField openReference::continued(const scalarField&, const boolList&) const;
template vectorField openReference::continued(const vectorField&, const boolList&) const;


scalar openReference::sticking(const label celli) const
{
    const scalar size = cbrt(s_.V[celli]);
    if (!s_.slips[celli])
    {
        return 1;
    }
    if (mag(s_.distance[celli]) >= 1.5*size)
    {
        return 0;
    }
    scalar turn = 0;
    for (const label facei : mesh_.facesOf(celli))
    {
        const plainFace& f = mesh_.faces()[facei];
        const label other = f.owner == celli ? f.neighbour : f.owner;
        turn += (s_.distance[other] - s_.distance[celli])*f.area/f.distance/sqr(size);
    }
    return turn <= 0.5 ? 0 : turn >= 1 ? 1 : 2*turn - 1;
}


vectorField openReference::blended(const vectorField& U) const
{
    vectorField result(continued(U, solid()));
    forAll(result, celli)
    {
        const scalar open = 1 - s_.gamma[celli];
        const scalar weight = open >= 0.5 ? 0 : open <= 0.1 ? 1 : (0.5 - open)/0.4;
        const vector missing(s_.Ub[celli] - result[celli]);
        const vector normal((s_.normal[celli] & missing)*s_.normal[celli]);
        result[celli] += weight*(normal + sticking(celli)*(missing - normal));
    }
    return result;
}


// * * * * * * * * * * * * * * * * * * Faces * * * * * * * * * * * * * * * * //

scalarField openReference::openFaces() const
{
    scalarField result(mesh_.faces().size());
    forAll(result, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        const bool shut = solid(f.owner) || solid(f.neighbour);
        result[facei] = shut ? 0 : s_.theta[facei]*f.linear(s_.fluid);
    }
    return result;
}


scalar openReference::leastOpen(const label celli) const
{
    return 1 - max(s_.gammaStart[celli], s_.gamma[celli]);
}


scalar openReference::merged(const label celli, const vector& outward) const
{
    const scalar open = leastOpen(celli);
    const scalar cosine = s_.normal[celli] & outward;
    return open < smallBelow && cosine > 0 ? sqr(1 - open/smallBelow)*sqr(cosine) : 0;
}


scalarField openReference::mergedFaces() const
{
    scalarField result(mesh_.faces().size(), Zero);
    forAll(result, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        if (!f.boundary && !solid(f.owner) && !solid(f.neighbour))
        {
            result[facei] = merged(f.owner, f.n) + merged(f.neighbour, -f.n);
        }
    }
    return result;
}


scalarField openReference::betweenLargeCells() const
{
    scalarField result(mesh_.faces().size(), 1);
    forAll(result, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        if (leastOpen(f.owner) < smallBelow || leastOpen(f.neighbour) < smallBelow)
        {
            result[facei] = 0;
        }
    }
    return result;
}


scalarField openReference::conducted
(
    const scalarField& conductance,
    const boolList& fixed,
    const scalarField& psi
) const
{
    const scalarField wide(mesh_.cells(psi));
    scalarField flux(mesh_.faces().size(), Zero);
    forAll(flux, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        const scalar other = fixed[facei] ? 0 : wide[f.neighbour];
        flux[facei] = conductance[facei]*f.area/f.distance*(wide[f.owner] - other);
    }
    return flux;
}


scalar openReference::holding(const scalarField& conductance, const boolList& fixed) const
{
    if (returnReduce(fixed.found(true), orOp<bool>()) || !Pstream::master())
    {
        return 0;
    }
    scalar sum = 0;
    for (const label facei : mesh_.facesOf(0))
    {
        const plainFace& f = mesh_.faces()[facei];
        sum += f.boundary ? 0 : conductance[facei]*f.area/f.distance;
    }
    return sum;
}


scalarField openReference::potential
(
    const scalarField& conductance,
    const boolList& fixed,
    const scalarField& outflow
) const
{
    scalarField psi(mesh_.nCells(), Zero);
    scalarField residual(outflow);
    scalarField direction(residual);
    scalar square = gSumSqr(residual);
    const scalar enough = 1e-30*square;
    const scalar held = holding(conductance, fixed);
    for (label i = 0; i < 5000 && square > enough; ++i)
    {
        scalarField image(mesh_.outflow(conducted(conductance, fixed, direction)));
        image[0] += held*direction[0];
        const scalar step = square/gSumProd(direction, image);
        psi += step*direction;
        residual -= step*image;
        const scalar before = square;
        square = gSumSqr(residual);
        direction = residual + square/before*direction;
    }
    return psi;
}


scalarField openReference::potentialFlux(const boolList& fixed, const scalarField& outflow) const
{
    const scalarField conductance(openFaces() + mergedFaces());
    return conducted(conductance, fixed, potential(conductance, fixed, outflow));
}


// * * * * * * * * * * * * * * * * *  Equations  * * * * * * * * * * * * * * //

vectorField openReference::convection(const scalarField& rhoPhi, const vectorField& wideU) const
{
    vectorField flux(mesh_.faces().size());
    forAll(flux, facei)
    {
        const plainFace& f = mesh_.faces()[facei];
        const bool cut = max(s_.gamma[f.owner], s_.gammaStart[f.owner]) > 0
            || max(s_.gamma[f.neighbour], s_.gammaStart[f.neighbour]) > 0;
        const vector upwind(rhoPhi[facei] >= 0 ? wideU[f.owner] : wideU[f.neighbour]);
        flux[facei] = rhoPhi[facei]*(cut ? upwind : f.linear(wideU));
    }
    return mesh_.outflow(flux)/s_.V;
}

} // End namespace Foam
