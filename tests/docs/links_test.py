#!/usr/bin/env python3
"""Every link of the pages leads to a file of the source tree, and to a heading where it names one.

usage: links_test.py SOURCE
"""

import pathlib
import re
import sys

SOURCE = pathlib.Path(sys.argv[1])


def anchors(page):
    """What the headings of a page are called in links, as GitHub and GitLab name them."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def broken(page):
    """Links of a page that lead nowhere, and how many it has."""
    text = re.sub(r"^```.*?^```", "", page.read_text(), flags=re.M | re.S)
    targets = [target for target in re.findall(r"\]\(([^) ]+)\)", text) if not re.match(r"https?:", target)]
    wrong = []
    for target in targets:
        name, _, anchor = target.partition("#")
        file = page.parent / name if name else page
        if not file.exists():
            wrong.append(f"{page} links to {target}, which is not there")
        elif anchor and anchor not in anchors(file):
            wrong.append(f"{page} links to {target}, and {file} has no such heading")
    return wrong, len(targets)


pages = sorted(SOURCE.glob("docs/**/*.md")) + [SOURCE / "README.md", SOURCE / "CHANGELOG.md"]
found = [broken(page) for page in pages]
print(f"{len(pages)} pages, {sum(count for _, count in found)} links")
wrong = [problem for problems, _ in found for problem in problems]
if wrong or sum(count for _, count in found) < 100:
    raise SystemExit("\n".join(wrong) or "hardly any link was found")
