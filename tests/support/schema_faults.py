"""Holds JSON files against a JSON Schema with the jsonschema library; other schemas it names lie beside it.

schema_faults.py SCHEMA FILE...   prints a line a fault; exit status 1 where there is one
"""

import json
import pathlib
import sys

import jsonschema


def no_number(word):
    raise ValueError(f"{word} is no JSON")


def main(schema_file, *files):
    where = pathlib.Path(schema_file).resolve()
    schema = json.loads(where.read_text(encoding="utf-8"))
    kind = jsonschema.validators.validator_for(schema)
    kind.check_schema(schema)
    validator = kind(schema, resolver=jsonschema.RefResolver(where.as_uri(), schema))
    found = 0
    for file in files:
        value = json.loads(pathlib.Path(file).read_text(encoding="utf-8"), parse_constant=no_number)
        for fault in validator.iter_errors(value):
            found += 1
            print(f"{file}: {fault.json_path}: {fault.message[:300]}")
    return 1 if found else 0


sys.exit(main(*sys.argv[1:]))
