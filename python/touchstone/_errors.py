# SPDX-License-Identifier: Apache-2.0
"""The exceptions that the module raises."""


class InvalidInput(ValueError):
    """Input outside the contract: the field, as it is written in JSON ("a[0][1]"), and the rule that it breaks."""

    field: str
    rule: str

    def __init__(self, field: str, rule: str) -> None:
        super().__init__(f"{field}: {rule}" if field else rule)
        self.field, self.rule = field, rule

    def __reduce__(self) -> tuple[type["InvalidInput"], tuple[str, str]]:
        return InvalidInput, (self.field, self.rule)


class CertificateRefused(ValueError):
    """A certificate that does not prove its claim; the text says why."""
