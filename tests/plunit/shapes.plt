:- use_module('../../prolog/interpretation').
:- use_module('../../prolog/loading').
:- use_module('../../prolog/shapes').
:- use_module(worlds).

:- begin_tests(shapes, [ setup(assertz(nppg_loading:defines(nppg_drawn, shapes/1))),
                         cleanup(retractall(nppg_loading:defines(nppg_drawn, _))) ]).

%   A module without a file: shapes/1 is all that it has.

draws(Given, Shapes) :-
    retractall(nppg_drawn:shapes(_)),
    assertz(nppg_drawn:shapes(Given)),
    shapes(nppg_drawn, Shapes).

test(each_kind, Shapes == [[box, 0, 0.5, 1, 2, object, b1], [disc, 1, 1, 0.25, 3, ''], [line, 0, 0, 1, 1, faint],
                           [text, 0, -1, 'f(x)']]) :-
    draws([box(0, 0.5, 1, 2, object, b1), disc(1, 1, 0.25, 3, ''), line(0, 0, 1, 1, faint), text(0, -1, f(x))], Shapes).
test(nothing, Shapes == []) :-
    draws([], Shapes).
test(undefined, Shapes == []) :-
    shapes(nppg_draws_nothing, Shapes).
test(no_list, throws(nppg_fault(_, 'gave no list of shapes'-[]))) :-
    draws(box(0, 0, 1, 1, object, b1), _).
test(no_shape, [ forall(member(Shape, [ box(0, 0, -1, 1, object, b), box(0, 0, 1, 1, pink, b), box(0, 0, 1, 1, 7, b),
                                       disc(x, 0, 1, object, b), disc(0, 0, -1, object, b), text(_, 0, b), star(0, 0),
                                       line(0, 0, 1.0e9, 0, faint), line(0, 0, 1, 0, '') ])),
                 throws(nppg_fault(_, 'gave ~p, which is no shape'-[_])) ]) :-
    draws([Shape], _).

test(blocks, Block == [box, 1.25, 1, 1, 1, wanted, a]) :-
    setup_call_cleanup(
        blocks(M),
        ( interpret(M, [on(a, b), on(b, floor), on(c, floor), goal_on(a, c)]),
          shapes(M, Shapes),
          memberchk(Block, [[box, 1.25, 1, 1, 1, wanted, a]]),
          memberchk(Block, Shapes) ),
        unload_domain(M)).

:- end_tests(shapes).
