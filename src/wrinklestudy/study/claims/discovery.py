"""The claims of a study, collected from its modules."""

from importlib import import_module

from wrinklestudy.study.claims.finding import Claim
from wrinklestudy.study.loading import CatalogueError, claim_modules


def load_claims(study: str) -> tuple[Claim, ...]:
    """Return the claims of a study in the order of `Claim.order`, then of the code.

    A claim belongs to the module in which its rule is defined.

    Parameters
    ----------
    study : str
        Name of the study as in the config: `loading.load_catalogue`.

    Raises
    ------
    CatalogueError
        If the study cannot be loaded or two claims have the same key.
    """
    claims: dict[str, Claim] = {}
    for name in claim_modules(study):
        for claim in vars(import_module(name)).values():
            if isinstance(claim, Claim) and claim.judge.__module__ == name:
                if claim.key in claims:
                    other = claims[claim.key].judge.__module__
                    raise CatalogueError(
                        f"study = {study!r}: claim {claim.key!r}: stands in {other} and in {name}"
                    )
                claims[claim.key] = claim
    return tuple(sorted(claims.values(), key=lambda claim: claim.order))
