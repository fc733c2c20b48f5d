"""The error with which a check ends."""


class Failure(Exception):
    """One sentence that says what is wrong."""


def check(holds, sentence):
    if not holds:
        raise Failure(sentence)
