# SPDX-License-Identifier: BSD-3-Clause
"""What a report needs of its studies, to be told before anything runs."""
from . import claims, published, selection


def check(studies):
    """Raises StudyError where a comparison, a claim or a published result cannot be reported."""
    for study in studies:
        for a, b in study.compare:
            selection.pairs(study, a, b)
        published.read_beside(study)
    claims.read_beside(studies)
