"""What a report needs of its studies, to be told before anything runs."""
from . import claims, selection


def check(studies):
    """Raises StudyError where a comparison or a claim of the studies cannot be reported."""
    for study in studies:
        for a, b in study.compare:
            selection.pairs(study, a, b)
    claims.read_beside(studies)
