:- use_module('../../prolog/model').
:- use_module('../../prolog/potential').

:- begin_tests(model).

written(File) :-
    tmp_file_stream(File, Out, [encoding(utf8), extension(pl)]),
    close(Out),
    new_policy(model_world, [], Policy),
    add_tree(Policy, [[2, [move, 0], [['A b', 0, 1], [on, 1, [floor]]], 0.5], [1, [], [], -1.25]]),
    write_model(File, toy, 'toy.pl', [[format, 1], [parameter, -(=, n, 3)]], Policy, [['one tree', 'First: this.', 'Then: that.']]),
    drop_policy(Policy).

test(text, Text == 'delta(1, move(A), 0.5) :- on(A, _), \'B c\'(A), !.') :-
    rule_text([], (delta(1, move(X), 0.5) :- on(X, _), 'B c'(X), !), Text).
test(names, Text == 'delta(1, move(Block, Block2), 0.5) :- on(Block, Place), over(Place, Block2), !.') :-
    rule_text([[move, block, block], [over, place, block]],
              (delta(1, move(X, Y), 0.5) :- on(X, Z), over(Z, Y), !), Text).
test(parts, Parts == [[move, ['Block', [floor]], 'move(Block, floor)'],
                      [[over, ['_', 'Block'], 'over(_, Block)'], [on, ['Block', ['\'A b\'']], 'on(Block, \\'A b\\')'], [dry, [], dry]],
                      0.5]) :-
    rule_parts([[move, block, place], [over, place, block]],
               (delta(1, move(X, floor), 0.5) :- over(_, X), on(X, 'A b'), dry, !), Parts).
test(parts_of_the_last, Parts == [[], [], -1.5]) :-
    rule_parts([], (delta(1, _, -1.5) :- true), Parts).
test(fact_text, Text == 'delta(1, _, 0.5).') :-
    rule_text([], (delta(1, _, 0.5) :- true), Text).
test(there_and_back, [true(Model = [Facts, toy, 'toy.pl', Rules]),
                      true(Facts-Rules = [[format, 1], [parameter, [=, n, 3]]]
                           -[ [_, 1, [move, 0], [['A b', 0, 1], [on, 1, [floor]]], 0.5, false], [_, 1, [], [], -1.25, true] ])]) :-
    written(File),
    read_model(File, Model).
test(no_model, throws(nppg_problems([-(_, 1, 0, _)]))) :-
    tmp_file_stream(File, Out, [extension(pl)]),
    format(Out, ':- initialization(shell(false)).~n', []),
    close(Out),
    read_model(File, _).
test(not_executed, [throws(nppg_problems([-(_, _, 0, _)]))]) :-
    written(File),
    setup_call_cleanup(open(File, append, Out), format(Out, ':- assertz(user:executed).~n', []), close(Out)),
    read_model(File, _).
test(cleanly, fail) :-
    catch(user:executed, _, fail).

test(sentences) :-
    written(File),
    read_file_to_string(File, Text, []),
    once(sub_string(Text, _, _, 0, "
% tree 1: one tree
% First: this.
delta(1, move(A), 0.5) :- 'A b'(A, B), on(B, floor), !.
% Then: that.
delta(1, _, -1.25).
")).

:- end_tests(model).
