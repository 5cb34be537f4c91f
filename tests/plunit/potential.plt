:- use_module('../../prolog/potential').

:- begin_tests(potential, [setup(new_world)]).

new_world :-
    forall(member(Fact, [clear(a), clear(b), on(a, b)]), assertz(little:Fact)).

%   delta(1, move(X), 1.0) :- clear(X), on(X, Y), !.    delta(1, move(X), 0.25).

tree([[2, [move, 0], [[clear, 0], [on, 0, 1]], 1.0], [1, [move, 0], [], 0.25]]).

test(none, [cleanup(drop_policy(Policy)), Potential == 0.0]) :-
    new_policy(little, [], Policy),
    potential(Policy, move(a), Potential).
test(first_answer, [cleanup(drop_policy(Policy)), Potentials == [1.0, 0.25, 0.0]]) :-
    new_policy(little, [], Policy),
    tree(Tree),
    add_tree(Policy, Tree),
    maplist(potential(Policy), [move(a), move(b), stay], Potentials).
test(sum, [cleanup(drop_policy(Policy)), Potential == 2.0]) :-
    new_policy(little, [], Policy),
    tree(Tree),
    add_tree(Policy, Tree),
    add_tree(Policy, Tree),
    potential(Policy, move(a), Potential).
test(rules, [cleanup(drop_policy(Policy)), true(Rules =@= [ (delta(1, move(X), 1.0) :- clear(X), on(X, _), !),
                                                          (delta(1, move(_), 0.25) :- true) ])]) :-
    new_policy(little, [], Policy),
    tree(Tree),
    add_tree(Policy, Tree),
    findall(Rule, rule(Policy, 1, Rule), Rules).

:- end_tests(potential).
