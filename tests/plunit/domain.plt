:- use_module('../../prolog/domain').
:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/loading').
:- use_module(worlds).

:- dynamic ferry/1.

:- begin_tests(domain, [ setup((ferry([], M), assertz(user:ferry(M)))),
                         cleanup((retract(user:ferry(M)), unload_domain(M))) ]).

%   Numbers are drawn as under nppg.bridge.prolog.randomness.

seeded(Goal) :-
    py_call('numpy.random':default_rng(0), Generator),
    py_call('nppg.bridge.prolog':randomness(Generator), Context),
    setup_call_cleanup(py_call(Context:'__enter__'()), once(Goal),
                       py_call(Context:'__exit__'(@(none), @(none), @(none)))).

towers([on(a, floor), on(b, floor), on(c, a), goal_on(a, b)]).

at([boat(left), fuel(3), car(c1, left), car(c2, left)]).

test(actions, Actions == [cross, carry(c1), carry(c2)]) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    actions(M, Actions).
test(status, Statuses == [running, goal, terminal]) :-
    ferry(M),
    findall(Status,
            ( member(Facts, [[boat(left), fuel(1), car(c1, left)], [boat(right), fuel(0), car(c1, right)],
                             [boat(right), fuel(0), car(c1, left)]]),
              interpret(M, Facts),
              status(M, Status) ),
            Statuses).
test(outcomes, Outcomes == [ 0.75-change([boat(left), fuel(2), car(c1, left)], [boat(right), fuel(1), car(c1, right)]),
                            0.25-change([fuel(2)], [fuel(1)]) ]) :-
    ferry(M),
    interpret(M, [boat(left), fuel(2), car(c1, left)]),
    outcomes(M, carry(c1), Outcomes).
test(uncovered, throws(nppg_fault(_, 'allows ~w, which no effect covers,'-[swim]))) :-
    ferry(M),
    outcomes(M, swim, _).
test(reward, Rewards == [10, -1]) :-
    ferry(M),
    interpret(M, [boat(right), fuel(0), car(c1, right)]),
    status(M, Good),
    reward(M, carry(c1), Good, Won),
    interpret(M, [boat(right), fuel(0), car(c1, left)]),
    status(M, Bad),
    reward(M, cross, Bad, Lost),
    Rewards = [Won, Lost].
test(horizon, Steps == 3) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    horizon(M, Steps).
test(experts, Actions == [carry(c1), carry(c2)]) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    experts(M, Actions).
test(objects, Objects == [c1, c2]) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    objects(M, waiting, Objects).
test(extension, Answers == [[c1], [c2]]) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    extension(M, waiting, 1, Answers0),
    msort(Answers0, Answers).
test(extension_of_what_is_no_test, throws(_)) :-
    ferry(M),
    extension(M, shell, 1, _).
test(binding, Values == [left]) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    binding(M, boat, 1, Values).
test(no_single_binding, throws(nppg_fault(_, _-[2]))) :-
    ferry(M), at(Facts),
    interpret(M, Facts),
    binding(M, waiting, 1, _).
test(parts, [setup(blocks(Blocks)), cleanup(unload_domain(Blocks)), Parts == [[a, c], [b]]]) :-
    interpret(Blocks, [on(a, floor), on(b, floor), on(c, a), goal_on(a, b)]),
    parts(Blocks, Parts).
test(observation, [setup(noisy(0.0, Noisy)), cleanup(unload_domain(Noisy)), Facts-Now == Sorted-State]) :-
    towers(Towers),
    sort(Towers, State),
    interpret(Noisy, State),
    seeded(observation(Noisy, Facts)),
    sort([goal_on(a, b), looks_clear(b), looks_clear(c), together(a, c), together(c, a)], Sorted),
    interpretation(Noisy, Now).
test(opposite_observation, [setup(noisy(1.0, Noisy)), cleanup(unload_domain(Noisy)), Clear == [a]]) :-
    towers(Towers),
    sort(Towers, State),
    interpret(Noisy, State),
    seeded(observation(Noisy, Facts)),
    findall(Block, member(looks_clear(Block), Facts), Clear).
test(unseeded_observation, [setup(noisy(0.1, Noisy)), cleanup(unload_domain(Noisy)),
                            throws(nppg_fault(Noisy:(observation/1), nppg_unseeded))]) :-
    towers(Towers),
    sort(Towers, State),
    interpret(Noisy, State),
    observation(Noisy, _).

:- end_tests(domain).
