#!/usr/bin/env python3
"""Whether draw.py, with the rule for sensible scenes, is the file whose checksum a page states: rule_is_frozen.py PAGE"""
import hashlib
import pathlib
import re
import sys

found = re.search(r"SHA-256[\s\w]*begins\s+with\s+([0-9a-f]{16})", pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
if not found:
    sys.exit(f"{sys.argv[1]} states no checksum of draw.py")
checksum = hashlib.sha256(pathlib.Path(__file__).with_name("draw.py").read_bytes()).hexdigest()
if not checksum.startswith(found.group(1)):
    sys.exit(f"draw.py has the checksum {checksum[:16]}, {sys.argv[1]} states {found.group(1)}: other scenes, not to be compared")
