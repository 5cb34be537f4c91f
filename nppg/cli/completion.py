"""nppg completion."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from pathlib import Path

from nppg.bridge.files import shipped
from nppg.cli import verbs

_BASH = """# eval "$(nppg completion bash)"
_nppg() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} words= files=yes
    case $COMP_CWORD-${{COMP_WORDS[1]}}-$previous in
    1-*) words="{commands} --help --version" files=no ;;
{cases}
    esac
    COMPREPLY=($(compgen -W "$words" -- "$current"))
    [[ $files == no || $current == -* ]] || COMPREPLY+=($(compgen -f -- "$current"))
}}
complete -o filenames -F _nppg nppg
"""
_ZSH = 'autoload -U +X compinit bashcompinit && compinit && bashcompinit  # eval "$(nppg completion zsh)"\n'


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The shell."""
    parser.add_argument("shell", choices=("bash", "zsh", "fish"), help='into ~/.bashrc: eval "$(nppg completion bash)"')


def run(options: argparse.Namespace) -> int:
    """Prints the script."""
    print({"bash": _bash, "zsh": lambda: _ZSH + _bash(), "fish": _fish}[options.shell](), end="")
    return 0


def _bash() -> str:
    cases = []
    for verb in verbs.VERBS:
        for names, choices, _ in _options(verb):
            if choices:
                pattern = " | ".join(f"*-{verb}-{name}" for name in names)
                cases.append(f'    {pattern}) words="{" ".join(choices)}" files=no ;;')
        words = [name for names, _, _ in _options(verb) for name in names if name.startswith("--")]
        cases.append(f'    *-{verb}-*) words="{" ".join([*words, *_arguments(verb)])}" ;;')
    return _BASH.format(commands=" ".join(verbs.VERBS), cases="\n".join(cases))


def _fish() -> str:
    lines = ["# nppg completion fish > ~/.config/fish/completions/nppg.fish"]
    for verb, what in verbs.VERBS.items():
        lines.append(f"complete -c nppg -n __fish_use_subcommand -f -a {verb} -d {_quoted(what)}")
        within = f"complete -c nppg -n '__fish_seen_subcommand_from {verb}'"
        lines += [f"{within} -a {_quoted(' '.join(words))}" for words in [_arguments(verb)] if words]
        for names, choices, help in _options(verb):
            values = f" -x -a {_quoted(' '.join(choices))}" if choices else ""
            lines += [f"{within} -l {name[2:]}{values} -d {_quoted(help)}" for name in names if name.startswith("--")]
    return "\n".join([*lines, ""])


def _options(verb: str) -> Iterator[tuple[list[str], list[str], str]]:
    """The names of each option of a verb, the values that it may have if these are few, and its help."""
    for action in verbs.parser_of(verb)[1]._actions:
        if action.option_strings:
            choices = _shipped() if action.metavar == "DOMAIN" else [str(each) for each in action.choices or ()]
            yield list(action.option_strings), choices, (action.help or "").replace("%%", "%")


def _arguments(verb: str) -> list[str]:
    """What may stand in a verb's places, but for files."""
    found = []
    for action in verbs.parser_of(verb)[1]._actions:
        if not action.option_strings:
            found += (
                _shipped() if "shipped domain" in (action.help or "") else [str(each) for each in action.choices or ()]
            )
    return found


def _shipped() -> list[str]:
    return sorted(file.stem for file in Path(shipped("domains")).glob("*.pl"))


def _quoted(text: str) -> str:
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"
