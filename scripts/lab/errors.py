"""What goes wrong in a way that the user can mend."""


class LabError(Exception):
    """Told in one line, without a trace; `status` is the exit status."""

    def __init__(self, message, status=2):
        super().__init__(message)
        self.status = status
