"""The check of a run's vertical momentum; what is balanced against what is in diagnostics/momentum.py."""
from diagnostics import momentum, Run


def check(folder, result, particle_density, body_mass):
    """Asserts the three balances to 1e-3 of the impulse on the body: of the fluid's, and of the whole one, which includes that
    of the contacts, for the whole system."""
    run = Run(folder)
    rows = momentum.steps(run)
    share = lambda rest: abs(rest) / momentum.impulse(rows)
    result.below("fluid's momentum, unexplained over the impulse on the body", share(momentum.fluid_rest(rows)), 1e-3)
    result.below("particles on the fluid: ledger against budget, over it", share(momentum.exchange_rest(run, rows)), 1e-3)
    terms = momentum.whole(run, rows, particle_density, body_mass)
    for name, value in terms.items():
        print(f"     momentum, {name}: {value:.6g} N s")
    whole = max(abs(terms["body"]), momentum.impulse(rows))
    result.below("momentum of the whole system, unexplained over the impulse on the body", abs(terms["unexplained"]) / whole, 1e-3)
