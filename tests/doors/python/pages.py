"""Whether pages can be tested; for scripts without pytest, too."""


def writes_pages():
    """Whether the package was built with the module for browsers."""
    import poinsot

    try:
        poinsot.Scene("sphere").page(size=(32, 18))
    except poinsot.EnvironmentError as error:
        return "without its module for browsers" not in str(error)
    return True
