:- use_module('../../prolog/formula').

:- begin_tests(formula, [setup(new_ferry), cleanup(drop_ferry)]).

new_ferry :-
    forall(member(Fact, [car(c1), car(c2), car(c3), place(l1), place(l2), red(c1), red(c2), at(c1, l1), at(c2, l1),
                         at(c3, l2), empty, fuel(c1, 3), fuel(c2, 5)]),
           assertz(formula_ferry:Fact)),
    dynamic([formula_ferry:on/1]),
    assertz(formula_ferry:(beside(X, Y) :- at(X, L), at(Y, L), X \== Y)).

drop_ferry :-
    forall(member(Name/Arity, [car/1, place/1, red/1, at/2, empty/0, fuel/2, on/1, beside/2]),
           abolish(formula_ferry:Name/Arity)).

h(Formula) :-
    holds(formula_ferry, Formula).

test(fact) :- h(holds(at(c1, l1))).
test(no_fact, fail) :- h(holds(at(c1, l2))).
test(plain_fact) :- h(holds(empty)).
test(clause) :- h(holds(beside(c1, c2))).
test(asked_by_a_module) :- formula_ferry:holds(and([holds(empty), not(holds(on(c1)))])).
test(not) :- h(not(holds(on(c1)))).
test(nothing_to_hold) :- h(and([])).
test(nothing_that_holds, fail) :- h(or([])).
test(and, fail) :- h(and([holds(empty), holds(on(c1))])).
test(or) :- h(or([holds(on(c1)), holds(empty)])).
test(forall) :- h(forall(['?c'-car], or([not(holds(red('?c'))), holds(at('?c', l1))]))).
test(forall_not, fail) :- h(forall(['?c'-car], holds(at('?c', l1)))).
test(forall_nothing) :- h(forall(['?c'-car], not(holds(on('?c'))))).
test(exists) :- h(exists(['?c'-car, '?l'-place], and([not(holds(red('?c'))), holds(at('?c', '?l'))]))).
test(exists_not, fail) :- h(exists(['?c'-car], holds(on('?c')))).
test(types_are_asked, fail) :- h(exists(['?c'-place], holds(red('?c')))).
test(either) :- h(forall(['?x'-[car, place]], or([not(holds(red('?x'))), not(eq('?x', l1))]))).
test(either_of_both, fail) :- h(forall(['?x'-[car, place]], not(eq('?x', l1)))).
test(inner_variable) :- h(exists(['?x'-car], and([holds(at('?x', l2)), exists(['?x'-car], holds(at('?x', l1)))]))).
test(some_place_for_all, fail) :- h(exists(['?l'-place], forall(['?c'-car], holds(at('?c', '?l'))))).
test(for_all_some_place) :- h(forall(['?c'-car], exists(['?l'-place], holds(at('?c', '?l'))))).
test(eq) :- h(eq(c1, c1)).
test(eq_not, fail) :- h(eq(c1, c2)).
test(two_of_them) :- h(exists(['?a'-car, '?b'-car], and([not(eq('?a', '?b')), holds(red('?a')), holds(red('?b'))]))).
test(not_three, fail) :-
    h(exists(['?a'-car, '?b'-car, '?c'-car],
             and([holds(red('?a')), holds(red('?b')), holds(red('?c')), not(eq('?a', '?b')), not(eq('?a', '?c')),
                  not(eq('?b', '?c'))]))).
test(compare) :- h(compare(>=, value(fuel(c1)), 3)).
test(compare_sum) :- h(compare(=:=, +(value(fuel(c1)), 2), value(fuel(c2)))).
test(compare_in_exists) :- h(exists(['?c'-car], compare(>, value(fuel('?c')), 4))).
test(no_value, fail) :- h(compare(>=, value(fuel(c3)), 0)).
test(not_ground, throws(error(instantiation_error, _))) :- h(holds(at(_, l1))).
test(no_formula, throws(error(domain_error(formula, halt), _))) :- h(halt).
test(no_expression, throws(error(domain_error(expression, cot(1)), _))) :- h(compare(<, cot(1), 2)).
test(no_list, throws(error(domain_error(formula, and(x)), _))) :- h(and(x)).

:- end_tests(formula).
