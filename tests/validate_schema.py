"""Documents against the JSON Schema that the command prints, by the package jsonschema.

python tests/validate_schema.py SCHEMA DOCUMENT...: every document must be valid, and no longer so once a key is taken
out, put in, or given a value of another type. Prints how many documents and how many changes there were.
"""

import copy
import json
import sys

from jsonschema import Draft202012Validator

OPTIONAL = {"walls", "stay", "exercise"}


def changes(document):
    for key in document:
        if key not in OPTIONAL:
            changed = copy.deepcopy(document)
            del changed[key]
            yield f"without {key}", changed
        for value in (None, {"no": "such"}):
            changed = copy.deepcopy(document)
            changed[key] = value
            yield f"{key} {value}", changed
    yield "an unknown key", {**document, "colour": "red"}
    yield "an unknown format", {**document, "format": "chess"}
    for role in ("adversarial", "cooperative"):
        for key, value in (("colour", "red"), ("sensor", 7), ("sensor", None), ("initial_belief", None)):
            changed = copy.deepcopy(document)
            changed["observers"][role][key] = value
            yield f"{role} {key} {value}", changed
        changed = copy.deepcopy(document)
        del changed["observers"][role]
        yield f"without {role}", changed
        changed = copy.deepcopy(document)
        del changed["observers"][role]["sensor"]
        yield f"{role} without a sensor", changed
    if "exercise" in document:
        for key, value in (("colour", "red"), ("kind", "riddle"), ("kind", None), ("attempts", 0), ("hints", "one")):
            changed = copy.deepcopy(document)
            changed["exercise"][key] = value
            yield f"exercise {key} {value}", changed
    if "goals" in document:
        changed = copy.deepcopy(document)
        changed["goals"][0]["colour"] = "red"
        yield "a goal with an unknown key", changed
        changed = copy.deepcopy(document)
        del changed["goals"][0]["name"]
        yield "a goal without a name", changed


def main(schema, *documents):
    with open(schema, encoding="utf-8") as file:
        schema = json.load(file)
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    wrong, tried = [], 0
    for path in documents:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
        wrong += [f"{path}: {error.message[:200]}" for error in validator.iter_errors(document)]
        for what, changed in changes(document):
            tried += 1
            if validator.is_valid(changed):
                wrong.append(f"{path}: {what} is taken for valid")
    print(f"{len(documents)} documents, {tried} changes")
    print("\n".join(wrong[:20]), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
