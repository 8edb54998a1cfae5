"""The notes that shots, deliveries or results carry, as tests look at them: by code and data."""


def codes(holder):
    """The codes of its notes."""
    return {each.code for each in holder.notes}


def noted(holder, code):
    """The data of its notes that have a code."""
    return [dict(each.data) for each in holder.notes if each.code == code]
