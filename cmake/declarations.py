# SPDX-License-Identifier: Apache-2.0
"""Finds declarations in our sources. The build reads C++ nowhere else; generate.py makes files of what is found."""
import re

INCLUDE = re.compile(r'^([ \t]*#[ \t]*include[ \t]*)"([^"\n]*)"', re.MULTILINE)


class Undeclared(Exception):
    """A source does not declare what is expected of it."""


def text_of(path):
    return path.read_text(encoding="utf-8")


def comment_text(comment):
    """The words of a comment of lines that begin with ///."""
    return re.sub("^/// ?", "", comment, flags=re.MULTILINE).strip()


def structs(text):
    """[(name, [(type, [field, ...]), ...]), ...]; a member of another form is ("", [])."""
    for name, body in re.findall(r"struct (\w+) {([^}]*)}", re.sub("//[^\n]*", "", text)):
        members = [re.fullmatch(r"(\w+) ([a-z_, ]+)", member.strip()) for member in body.split(";") if member.strip()]
        yield name, [(member[1], member[2].split(", ")) if member else ("", []) for member in members]


def enumeration(text, name):
    """(its comment, its enumerators), or None."""
    found = re.search(rf"((?:///[^\n]*\n)*)enum class {name} {{([^}}]*)}}", text)
    return found and (comment_text(found[1]), [word for word in re.sub("[ \n]", "", found[2]).split(",") if word])


def prepared(text, name):
    """(class, [(type, operand), ...]) of the overload of a decision that takes a shape of robust/prepared, or None."""
    for shape in re.findall(r"^class (\w+);", text, re.MULTILINE):
        found = re.search(rf"void {name}\(([^)]*const {shape}& [^)]*),[ \n]*std::size_t count,", text)
        if found:
            operands = [re.fullmatch(r"const (\w+)& (\w+)", " ".join(each.split())) for each in found[1].split(",")]
            return shape, [operand.groups() for operand in operands]
    return None


def decision(header, text, name):
    """(its comment, for each overload [(type, operand), ...]) of a decision over arrays, but not of prepared shapes."""
    declaration = rf"void {name}\(([^)]*),[ \n]*std::size_t count,[ \n]*std::uint8_t\* [a-z]+[^)]*\);"
    contract = re.search(rf"((?:///[^\n]*\n)+){declaration}", text)
    if not contract:
        raise Undeclared(f"{header}: no contract stands above void {name}(operands..., std::size_t count, "
                         "std::uint8_t* answers)")
    overloads = []
    for parameters in re.findall(declaration, text):
        operands = [re.fullmatch(r"const (\w+)& (\w+)", " ".join(each.split())) for each in parameters.split(",")]
        if None in operands:
            raise Undeclared(f"{header}: expected const SHAPE& operand, found: {parameters}")
        operands = [operand.groups() for operand in operands]
        if not any(re.search(rf"^class {shape};", text, re.MULTILINE) for shape, _ in operands):  # which is for C++ alone
            overloads.append(operands)
    return comment_text(contract[1]), overloads


def contract(header, text, name):
    """The comment above a function or a template, with the line break before each of its lines."""
    found = re.search(rf"((?:\n///[^\n]*)+)\n(?:template[^\n]*\n)?[^\n]* {name}\(", text)
    if not found:
        raise Undeclared(f"{header}: no contract stands above {name}")
    return re.sub("\n/// ?", "\n", found[1])


def checks(text):
    """The function that has the checks of a file, or None."""
    found = re.search(r"^Checks (checks_of_[a-z_]+)\(\)", text, re.MULTILINE)
    return found and found[1]


def place(header, text):
    """Where a row stands in the deck: of pages = "2, 14" or "45-47, 51", the last."""
    found = re.search(r'\.pages = "(?:[0-9-]+, )*(\d+)-?(\d*)"', text)
    if not found:
        raise Undeclared(f"{header}: no pages of the deck")
    return int(found[1]), int(found[2] or 0)


def has_own_namespace(text, name):
    return re.search(rf"^namespace touchstone::proptests::{name}_tests {{", text, re.MULTILINE) is not None
