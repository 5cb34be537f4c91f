"""Learn to act in structured worlds by non-parametric policy gradients, and read what was learned as rules."""

from __future__ import annotations

import argparse
import json
import math
import signal
import sys
import time
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import Field, asdict, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nppg import __version__
from nppg.bias.language_bias import LanguageBias, TreeLimits
from nppg.bridge.files import locate, shipped
from nppg.errors import NppgError, Problem
from nppg.experiments.learners import LEARNERS
from nppg.experiments.paper import EXPERIMENTS
from nppg.learning.options import Common, Options, at_least, kind_of

if TYPE_CHECKING:
    from nppg.experiments.runs import Point, Progress
    from nppg.policy.policy import Policy
    from nppg.worlds.domain import Domain, State

_LIMITS = {
    "max_depth": "tests on the longest path of a tree",
    "min_examples": "each leaf holds at least so many examples",
    "min_variance": "a node with less is a leaf; 1e-9 is in the square of the largest return, any other is absolute",
    "significance": "level of the F-test that a split must pass; 1 switches it off",
    "granularity": "at most so many thresholds of a bound are tried at a node; 0: every cut point",
}
_RENAMED = {"min_examples": "min_leaf"}  # the option's name where another option has the field's


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs one command. Returns the exit status: 0, 2 after a mistake, 130 after Ctrl-C."""
    arguments = sys.argv[1:] if arguments is None else arguments
    options = _parser().parse_args(arguments, argparse.Namespace(arguments=arguments))
    try:
        if options.command == "doctor":
            return _doctor()
        from nppg.bridge.prolog import interruptible

        with interruptible():
            return options.function(options)
    except NppgError as error:
        print(error, file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)  # a second Ctrl-C is not to change the status
        print("interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:
        sys.stderr.close()
        return 0


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="nppg", description=__doc__.split("\n")[0], allow_abbrev=False)
    parser.add_argument("--version", action="version", version=f"nppg {__version__}")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")

    def command(name: str, function: Callable[[argparse.Namespace], int], help: str) -> argparse.ArgumentParser:
        added = commands.add_parser(name, help=help, description=help, allow_abbrev=False)
        added.set_defaults(function=function)
        return added

    command("doctor", lambda _: _doctor(), "look whether everything that nppg needs is there")
    check = command("check", _check, "report every mistake in a domain and its language bias")
    train = command("train", _train, "learn a policy")
    for each in (check, train):
        each.add_argument("domain", help="a shipped domain's name, a file, or gym:ID for an environment of Gymnasium")
        each.add_argument("--bias", help="language bias (default: the file of the domain's name, or a generated one)")
    evaluate = command("evaluate", _evaluate, "measure a policy's success")
    show = command("show", _show, "print a policy's trees")
    play = command("play", _play, "draw one episode step by step")
    for each in (evaluate, show, play):
        each.add_argument("model", type=Path, help="a model file")
    for each in (check, train, evaluate, play):
        each.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the domain")
    prove = command("prove", _prove, "show from which start states a policy can fail, and write a certificate")
    distill = command("distill", _distill, "write few rules that choose like a policy of many trees")
    for each in (prove, distill):
        each.add_argument("model", type=Path, help="a model file")
    for each in (distill, show):
        each.add_argument("--explain", action="store_true", help="say in plain English what each rule does")
    for each in (prove,):
        each.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the domain")
    prove.add_argument("--stochastic", action="store_true", help="about the stochastic policy, not the greedy one")
    prove.add_argument("--output", type=Path, metavar="FILE", help="the certificate, as JSON")
    prove.add_argument(
        "--check",
        type=Path,
        metavar="FILE",
        help="refuse this certificate where it differs from the proof, which is done again and takes as long",
    )
    prove.add_argument("--show", type=int, default=3, metavar="N", help="failing classes to draw (default: 3)")
    distill.add_argument("--max-rules", type=int, default=10, metavar="N", help="(default: 10)")
    distill.add_argument("--bias", help="what the rules may test (default: the bias that the model was trained with)")
    distill.add_argument(
        "--output", type=Path, metavar="FILE", help="the rules' model file (default: MODEL's folder, rules.pl)"
    )
    reproduce = command("reproduce", _reproduce, "do an experiment of the paper: its runs, its figure, a report")
    reproduce.add_argument("experiment", choices=EXPERIMENTS)
    reproduce.add_argument("--runs", type=int, help="runs of each variant, seeds from 0 (default: as in the paper)")
    reproduce.add_argument("--episodes", type=int, help="of each run (default: as in the paper)")
    reproduce.add_argument("--jobs", type=int, help="runs at a time (default: the cores there are)")
    reproduce.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="a parameter of the domain")
    reproduce.add_argument(
        "--output",
        type=Path,
        default=Path("runs/reproduce"),
        help="folder for all; finished runs that it has are not done again (default: runs/reproduce)",
    )
    new = command("new", _new, "write a commented domain and language bias to start from")
    new.add_argument("name")

    train.add_argument("--learner", choices=LEARNERS, default=Options.learner, help="(default: nppg)")
    for name, owners in _training_options().items():
        _add_option(train, name, owners)
    train.add_argument("--output", type=Path, help="folder for the files (default: runs/DOMAIN)")
    train.add_argument(
        "--evaluate-every",
        type=int,
        default=50,
        metavar="N",
        help="episodes between two points of the curve; 0: none (default: 50)",
    )
    train.add_argument("--starts", type=int, default=200, help="starts of a sampled point of the curve (default: 200)")
    train.add_argument(
        "--until-success", type=float, metavar="P", help="stop at the first point of the curve with this success"
    )
    train.add_argument(
        "--until-return",
        type=float,
        metavar="R",
        help="stop at the first point with this mean return; points are then sampled, not exact",
    )
    train.add_argument("--quiet", action="store_true", help="print nothing")

    how = evaluate.add_mutually_exclusive_group()
    how.add_argument("--exact", action="store_true", help="over all start states")
    how.add_argument("--starts", type=int, default=1000, help="number of sampled starts (default: 1000)")
    evaluate.add_argument("--greedy", action="store_true", help="take the most probable action")
    evaluate.add_argument(
        "--horizon-factor", type=float, metavar="FLOAT", help="of the domain's horizon (default: as in training)"
    )
    evaluate.add_argument("--json", action="store_true", help="print one JSON object")
    for each in (evaluate, play):
        each.add_argument("--seed", type=int, default=0)
    show.add_argument("--bias", help="whose sentences explain (default: the bias that the model was trained with)")
    show.add_argument("--tree", type=int, metavar="N", help="this tree alone, from 1")
    show.add_argument("--format", choices=("prolog", "dot"), default="prolog")
    return parser


def _training_options() -> dict[str, dict[str, Field]]:
    """The options of `train` by name, each with its learners."""
    found: dict[str, dict[str, Field]] = {}
    for learner, options in LEARNERS.items():
        for field in fields(options):
            found.setdefault(field.name, {})[learner] = field
    for field in fields(TreeLimits):
        found.setdefault(_RENAMED.get(field.name, field.name), {})[Options.learner] = field
    return found


def _add_option(parser: argparse.ArgumentParser, name: str, owners: Mapping[str, Field]) -> None:
    defaults = {
        learner: str(each.default) if each.metadata else "the language bias's" for learner, each in owners.items()
    }
    if len(set(defaults.values())) == 1:
        shown = next(iter(defaults.values()))
    else:
        shown = ", ".join(f"{learner} {default}" for learner, default in defaults.items())
    only = "" if len(owners) == len(LEARNERS) else f"{', '.join(owners)}: "
    first = next(iter(owners.values()))
    choices = first.metadata.get("choices")
    parser.add_argument(
        f"--{name.replace('_', '-')}",
        dest=name,
        type=kind_of(first),
        choices=choices,
        metavar=None if choices else kind_of(first).__name__.upper(),
        help=f"{only}{first.metadata.get('help') or _LIMITS[first.name]}"
        + ("" if first.default is None else f" (default: {shown})"),
    )


def _chosen_options(options: argparse.Namespace) -> dict[str, Any]:
    """Those that were given. Raises NppgError for those that the learner does not have."""
    given: dict[str, Any] = {}
    for name, owners in _training_options().items():
        value = getattr(options, name)
        if value is not None and options.learner not in owners:
            raise NppgError(
                f"--{name.replace('_', '-')} is no option of the learner {options.learner}, but of {', '.join(owners)}"
            )
        given |= {} if value is None else {name: value}
    return given


def _parameters(settings: list[str]) -> dict[str, int | float | str]:
    found: dict[str, int | float | str] = {}
    for setting in settings:
        name, equals, text = setting.partition("=")
        if not (name and equals and text):
            raise NppgError(f"--set takes NAME=VALUE, not '{setting}'")
        found[name] = _value(text)
    return found


def _value(text: str) -> int | float | str:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def _domain(options: argparse.Namespace) -> Domain:
    from nppg.worlds.opening import open_domain

    with _warnings_told():
        return open_domain(options.domain, _parameters(options.set))


@contextmanager
def _warnings_told(tell: bool = True) -> Iterator[None]:
    """Prints each warning on a line of its own."""
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        yield
    for each in noted if tell else ():
        print(f"warning: {each.message}", file=sys.stderr)


def _bias(options: argparse.Namespace, domain: Domain | None) -> LanguageBias | None:
    """The file given by --bias, or what goes with the domain, if that could be loaded or at least be found."""
    from nppg.worlds.opening import bias_path, is_environment, language_bias_of

    if options.bias:
        return LanguageBias.load(locate(options.bias, "language_bias", ".yaml"))
    if domain:
        return language_bias_of(domain)
    if is_environment(options.domain):
        return None
    return LanguageBias.load(bias_path(locate(options.domain, "domains", ".pl"), _parameters(options.set)))


def _doctor() -> int:
    from nppg.bridge.doctor import doctor, report

    checks = doctor()
    print(report(checks))
    return 0 if all(check.ok for check in checks) else 2


def _check(options: argparse.Namespace) -> int:
    from nppg.answers.check import check

    problems, summary = check(lambda: _domain(options), lambda domain: _bias(options, domain))
    if problems:
        raise NppgError(problems)
    print(summary)
    return 0


def _train(options: argparse.Namespace) -> int:
    from nppg.experiments.runs import run

    given = _chosen_options(options)
    kind = LEARNERS[options.learner]
    chosen = kind(**{field.name: given.pop(field.name) for field in fields(kind) if field.name in given})
    at_least("evaluate-every", options.evaluate_every, 0)
    at_least("starts", options.starts, 1)
    domain = _domain(options)
    bias = _bias(options, domain)
    assert bias
    limits = {field.name: _RENAMED.get(field.name, field.name) for field in fields(TreeLimits)}
    bias = replace(bias, tree=replace(bias.tree, **{name: given[own] for name, own in limits.items() if own in given}))
    output = options.output or Path("runs") / domain.name
    report = (lambda progress: None) if options.quiet else _reporter(chosen)
    until = options.until_success
    if until is not None and not (0 <= until <= 1 and options.evaluate_every):
        raise NppgError("until-success must be from 0 to 1, and needs points of the curve (evaluate-every)")
    least = options.until_return
    if least is not None and not (math.isfinite(least) and options.evaluate_every):
        raise NppgError("until-return must be a finite number, and needs points of the curve (evaluate-every)")
    progress = run(
        domain, bias, chosen, output, options.evaluate_every, options.starts, report, until, until_return=least
    )
    if not options.quiet:
        print(f"written to {output}/: {', '.join(progress.written)}")
    return 0


def _reporter(options: Common) -> Callable[[Progress], None]:
    """A progress bar on a terminal with tqdm, plain lines elsewhere."""
    from nppg.experiments.runs import sizes

    bar = None
    if sys.stderr.isatty():
        try:
            from tqdm import tqdm
        except ImportError:
            pass
        else:
            bar = tqdm(total=options.episodes, unit="episode", dynamic_ncols=True)

    def show(progress: Progress) -> None:
        point = progress.point
        if bar is not None:
            bar.update(progress.episodes - bar.n)
            bar.set_postfix(progress.policy.sizes(), lately=f"{progress.recent:.2f}")
            if progress.ended:
                bar.close()
        elif point is not None:
            stochastic, greedy = progress.judged(point)
            print(
                f"episode {point.episode:5d}  {sizes(progress.policy)}  {progress.measure} {stochastic:.4f} "
                f"(greedy {greedy:.4f})  {_returns(progress, point)}{point.seconds:.1f} s",
                flush=True,
            )

    return show


def _returns(progress: Progress, point: Point) -> str:
    """What a point's line says of returns, where success is the measure and does not tell them."""
    if progress.measure == "return" or point.mean_return is None or math.isclose(point.mean_return, point.success):
        return ""
    return f"return {point.mean_return:.2f} (greedy {point.greedy_return:.2f})  "


def _reproduce(options: argparse.Namespace) -> int:
    from nppg.experiments import figures
    from nppg.experiments.reproduce import available_cores, do, jobs

    experiment = EXPERIMENTS[options.experiment]
    processes = available_cores() if options.jobs is None else options.jobs
    runs = experiment.runs if options.runs is None else options.runs
    episodes = experiment.episodes if options.episodes is None else options.episodes
    for name, value in (("runs", runs), ("jobs", processes)):
        at_least(name, value, 1)
    wanted = jobs(experiment, runs, episodes, _parameters(options.set), options.output)
    begin, done = time.perf_counter(), 0
    for count, (job, seconds) in enumerate(do(wanted, processes), 1):
        done += seconds > 0
        how = f"{seconds:.0f} s" if seconds else "done before"
        print(f"{count:3d} of {len(wanted)}: {job.folder.name}, {job.result()}, {how}", flush=True)
    command = " ".join(["nppg", "reproduce", *(options.arguments[1:])])
    took = time.perf_counter() - begin if done else 0.0
    for path in figures.write(experiment.name, wanted, options.output, command, took):
        print(f"written: {path}")
    return 0


def _load(options: argparse.Namespace) -> Policy:
    from nppg.policy.policy import Policy

    with _warnings_told(options.command != "prove"):  # which refuses instead
        return Policy.load(options.model, _parameters(getattr(options, "set", [])))


def _evaluate(options: argparse.Namespace) -> int:
    from nppg.judging.evaluation import evaluate, evaluate_exactly, merit

    policy = _load(options)
    given = options.horizon_factor
    factor = Options(horizon_factor=policy.option("horizon_factor", 1.0) if given is None else given).horizon_factor
    if options.exact:
        result = evaluate_exactly(policy, options.greedy, factor)
    else:
        result = evaluate(policy, options.starts, options.seed, options.greedy, factor)
    if options.json:
        print(json.dumps(asdict(result)))
    else:
        kind = "greedy" if result.greedy else "stochastic"
        over = f"all {result.starts:,} start states" if result.exact else f"{result.starts:,} sampled start states"
        steps = f"{result.mean_steps:.3f} steps on average"
        name, value = merit(policy, result)
        print(f"{name.replace('_', ' ')} of the {kind} policy over {over}: {value:.6f} ({steps})")
    return 0


def _prove(options: argparse.Namespace) -> int:
    from nppg.rules.proof import check_certificate, prove

    policy = _load(options)
    proof = prove(policy, options.model, greedy=not options.stochastic)
    if options.check:
        check_certificate(options.check, proof)
        print(f"{options.check} is right: {options.model} was proved again, with the same result")
    kind = "greedy" if proof.greedy else "stochastic"
    print(f"{proof.classes:,} classes of {proof.states:,} states, {proof.starts:,} of them start states")
    for failure in proof.failures[: options.show]:
        print(
            "",
            f"from {failure.states:,} states like this it succeeds with probability {failure.success:.6f}:",
            sep="\n",
        )
        print(*failure.picture, sep="\n")
    verdict = (
        "from every one"
        if proof.complete
        else f"with {proof.success:.9f}; it can fail in {len(proof.failures)} classes"
    )
    print(f"the {kind} policy succeeds {verdict}")
    if options.output:
        proof.save(options.output)
        print(f"certificate: {options.output}")
    return 0


def _distill(options: argparse.Namespace) -> int:
    from nppg.judging.evaluation import evaluate, evaluate_exactly, merit
    from nppg.rules.distill import distill
    from nppg.rules.explain import explained, sentences

    at_least("max-rules", options.max_rules, 1)
    policy = _load(options)
    bias = _bias_of(policy, options)
    rules = distill(policy, bias, options.max_rules)
    exact = policy.domain.is_countable
    result = evaluate_exactly(rules, greedy=True) if exact else evaluate(rules, seed=1, greedy=True)
    judged, value = merit(rules, result)
    output = options.output or options.model.with_name("rules.pl")
    beside = Path(bias.file).resolve().parent == output.resolve().parent
    facts = [
        *([("bias", Path(bias.file).name), ("bias_sha256", bias.hash)] if beside else []),
        *((judged, value), ("starts", result.starts), ("exact", int(result.exact))),
    ]
    rules.save(output, facts, [sentences(rules, 1, bias)] if options.explain else ())
    print(*(explained(rules, 1, bias) if options.explain else rules.rules(1)), sep="\n")
    over = "all" if result.exact else "sampled"
    print(
        f"{judged.replace('_', ' ')} of these rules over {over} {result.starts:,} start states: {value:.6f}; "
        f"written to {output}"
    )
    return 0


def _bias_of(policy: Policy, options: argparse.Namespace) -> LanguageBias:
    """The file given by --bias, or the one that the model names."""
    if not options.bias and "bias" not in policy.facts:
        raise NppgError([Problem(str(options.model), 0, 0, "the model names no language bias; give one by --bias")])
    return LanguageBias.load(locate(options.bias or policy.bias.file, "language_bias", ".yaml"))


def _show(options: argparse.Namespace) -> int:
    from nppg.rules.dot import dot
    from nppg.rules.explain import explained

    if options.explain and options.format == "dot":
        raise NppgError("--explain is about rules, which --format dot does not show")
    policy = _load(options)
    count = len(policy.trees)
    if options.tree is not None and not 1 <= options.tree <= count:
        raise NppgError(f"there is no tree {options.tree}: the model has {count}")
    bias = _bias_of(policy, options) if options.explain else None
    for number in range(1, count + 1) if options.tree is None else [options.tree]:
        if options.format == "dot":
            print(dot(policy.trees[number - 1], policy.bias, f"tree_{number}"))
        else:
            rules = explained(policy, number, bias) if bias else policy.rules(number)
            print(f"% tree {number}: {policy.comments[number - 1]}", *rules, "", sep="\n")
    return 0


def _play(options: argparse.Namespace) -> int:
    from nppg.learning.episode import generate_episode

    at_least("seed", options.seed, 0)
    policy = _load(options)
    episode = generate_episode(policy, np.random.default_rng(options.seed))
    for number, step in enumerate(episode.steps, 1):
        print(*policy.domain.picture(step.actual), "", *_seen(policy, step.state), f"step {number}", sep="\n")
        pairs = zip(step.actions, step.potentials if policy.greedy else step.probabilities, strict=True)
        for action, value in sorted(pairs, key=lambda pair: -pair[1]):
            mark = "->" if action is step.actions[step.chosen] else "  "
            print(f"  {mark} {value:6.4f}  {_text(action)}")
        print()
    print(*policy.domain.picture(episode.actual), "", sep="\n")
    if policy.domain.has_goal:
        end = "the goal is reached" if episode.success else "the goal is not reached"
    else:
        end = f"the return is {sum(step.reward for step in episode.steps):g}"
    print(f"{end} after {len(episode.steps)} steps")
    return 0


def _seen(policy: Policy, observation: State) -> list[str]:
    """What the policy sees, where that is not the state."""
    if not policy.domain.has_observation:
        return []
    return ["seen: " + ", ".join(map(_text, observation)), ""]


def _text(term: object) -> str:
    return f"{term[0]}({', '.join(map(_text, term[1:]))})" if isinstance(term, tuple) else str(term)


def _new(options: argparse.Namespace) -> int:
    name = options.name
    if not (name.isidentifier() and name[0].islower()):
        raise NppgError(f"'{name}' cannot be a domain's name: write a lower-case letter, then letters, digits or _")
    files = [Path(f"{name}.pl"), Path(f"{name}.yaml")]
    for file in files:
        if file.exists():
            raise NppgError([Problem(str(file), 0, 0, "exists already and is left as it is")])
    for file, folder in zip(files, ("domains", "language_bias"), strict=True):
        text = (shipped(folder) / f"delivery{file.suffix}").read_text(encoding="utf-8")
        lines = [line for line in text.splitlines() if "$schema" not in line]
        try:
            file.write_text("\n".join(lines).replace("delivery", name) + "\n", encoding="utf-8")
        except OSError as error:
            raise NppgError([Problem(str(file), 0, 0, f"cannot be written: {error.strerror}")]) from None
    print(f"written: {files[0]} and {files[1]}; next: nppg check {files[0]}, then nppg train {files[0]}")
    return 0
