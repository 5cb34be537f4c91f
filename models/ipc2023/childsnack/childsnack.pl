:- module(childsnack, []).

% The PDDL domain childsnack. What no action changes is static: it belongs to the problem. So do its goals:
% goal_served(C) says that served(C) is wanted, condition/1 has what is wanted beyond such facts, and goals/1 says how
% many literals that is in all.

:- pddl('domain.pddl').
:- static child/1, bread_portion/1, content_portion/1, sandwich/1, tray/1, place/1, no_gluten_bread/1,
     no_gluten_content/1, allergic_gluten/1, not_allergic_gluten/1, waiting/2, goal_served/1, goals/1, condition/1.
:- fluent at_kitchen_bread/1, at_kitchen_content/1, at_kitchen_sandwich/1, ontray/2, no_gluten_sandwich/1, served/1,
     at/2, notexist/1.
:- dead_ends.
:- discontiguous action/1, effect/3.

% make_sandwich_no_gluten
action(make_sandwich_no_gluten(S, B, C)) :-
    no_gluten_content(C),
    at_kitchen_content(C),
    no_gluten_bread(B),
    at_kitchen_bread(B),
    notexist(S).
effect(make_sandwich_no_gluten(S, B, C), [at_kitchen_bread(B), at_kitchen_content(C), notexist(S)],
    [at_kitchen_sandwich(S), no_gluten_sandwich(S)]).

% make_sandwich
action(make_sandwich(S, B, C)) :- at_kitchen_bread(B), at_kitchen_content(C), notexist(S).
effect(make_sandwich(S, B, C), [at_kitchen_bread(B), at_kitchen_content(C), notexist(S)], [at_kitchen_sandwich(S)]).

% put_on_tray
action(put_on_tray(S, T)) :- at_kitchen_sandwich(S), at(T, kitchen).
effect(put_on_tray(S, T), [at_kitchen_sandwich(S)], [ontray(S, T)]).

% serve_sandwich_no_gluten
action(serve_sandwich_no_gluten(S, C, T, P)) :-
    ontray(S, T),
    no_gluten_sandwich(S),
    at(T, P),
    waiting(C, P),
    allergic_gluten(C).
effect(serve_sandwich_no_gluten(S, C, T, _P), [ontray(S, T)], [served(C)]).

% serve_sandwich
action(serve_sandwich(S, C, T, P)) :- ontray(S, T), at(T, P), waiting(C, P), not_allergic_gluten(C).
effect(serve_sandwich(S, C, T, _P), [ontray(S, T)], [served(C)]).

% move_tray
action(move_tray(T, P1, P2)) :- at(T, P1), place(P2), \+ at(T, P2).
effect(move_tray(T, P1, P2), [at(T, P1)], [at(T, P2)]).

goal :- \+ ( goal_served(C), \+ served(C) ), \+ ( condition(Formula), \+ holds(Formula) ).
horizon(Steps) :- goals(Count), Steps is 8*Count+10.

% what is left to do, and what is done
todo_served(C) :- goal_served(C), \+ served(C).
done_served(C) :- goal_served(C), served(C).

% derived from the types and the actions
needed_at_to_serve_sandwich_no_gluten(Place) :-
    waiting(Child, Place),
    todo_served(Child),
    \+ ( waiting(Child, Place2), at(_Tray, Place2) ).
could_put_on_tray(Tray, kitchen) :- at_kitchen_sandwich(Sandwich), \+ ontray(Sandwich, Tray).
could_serve_sandwich_no_gluten(Tray, Place) :-
    ontray(Sandwich, Tray),
    no_gluten_sandwich(Sandwich),
    waiting(Child, Place),
    \+ served(Child),
    allergic_gluten(Child).
could_serve_sandwich(Tray, Place) :-
    ontray(_Sandwich, Tray),
    waiting(Child, Place),
    \+ served(Child),
    not_allergic_gluten(Child).
:- table number_ontray_1/1.
number_ontray_1(N) :- findall(X, ontray(X, _Tray), Found), sort(Found, Set), length(Set, N).
:- table number_todo_served/1.
number_todo_served(N) :- findall(X, todo_served(X), Found), sort(Found, Set), length(Set, N).
fewer_ontray_1_than_todo_served :- number_ontray_1(N), number_todo_served(M), N < M.
:- table number_allergic_gluten/1.
number_allergic_gluten(N) :- findall(X, allergic_gluten(X), Found), sort(Found, Set), length(Set, N).
fewer_ontray_1_than_allergic_gluten :- number_ontray_1(N), number_allergic_gluten(M), N < M.
both_todo_served_allergic_gluten(X) :- todo_served(X), allergic_gluten(X).
:- table number_todo_served_allergic_gluten/1.
number_todo_served_allergic_gluten(N) :-
    findall(X, both_todo_served_allergic_gluten(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_ontray_1_than_todo_served_allergic_gluten :- number_ontray_1(N), number_todo_served_allergic_gluten(M), N < M.
:- table number_no_gluten_sandwich/1.
number_no_gluten_sandwich(N) :- findall(X, no_gluten_sandwich(X), Found), sort(Found, Set), length(Set, N).
fewer_no_gluten_sandwich_than_todo_served :- number_no_gluten_sandwich(N), number_todo_served(M), N < M.
fewer_no_gluten_sandwich_than_allergic_gluten :- number_no_gluten_sandwich(N), number_allergic_gluten(M), N < M.
fewer_no_gluten_sandwich_than_todo_served_allergic_gluten :-
    number_no_gluten_sandwich(N),
    number_todo_served_allergic_gluten(M),
    N < M.
both_ontray_1_no_gluten_sandwich(X) :- ontray(X, _Tray), no_gluten_sandwich(X).
:- table number_ontray_1_no_gluten_sandwich/1.
number_ontray_1_no_gluten_sandwich(N) :-
    findall(X, both_ontray_1_no_gluten_sandwich(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_ontray_1_no_gluten_sandwich_than_allergic_gluten :-
    number_ontray_1_no_gluten_sandwich(N),
    number_allergic_gluten(M),
    N < M.
:- table number_ontray_2/1.
number_ontray_2(N) :- findall(X, ontray(_Sandwich, X), Found), sort(Found, Set), length(Set, N).
fewer_ontray_2_than_todo_served :- number_ontray_2(N), number_todo_served(M), N < M.
fewer_ontray_2_than_allergic_gluten :- number_ontray_2(N), number_allergic_gluten(M), N < M.
:- table number_at_1/1.
number_at_1(N) :- findall(X, at(X, _Place), Found), sort(Found, Set), length(Set, N).
fewer_at_1_than_todo_served :- number_at_1(N), number_todo_served(M), N < M.
fewer_at_1_than_allergic_gluten :- number_at_1(N), number_allergic_gluten(M), N < M.
fewer_at_1_than_todo_served_allergic_gluten :- number_at_1(N), number_todo_served_allergic_gluten(M), N < M.
:- table number_at_2/1.
number_at_2(N) :- findall(X, at(_Tray, X), Found), sort(Found, Set), length(Set, N).
fewer_at_2_than_todo_served :- number_at_2(N), number_todo_served(M), N < M.
fewer_at_2_than_allergic_gluten :- number_at_2(N), number_allergic_gluten(M), N < M.
fewer_at_2_than_todo_served_allergic_gluten :- number_at_2(N), number_todo_served_allergic_gluten(M), N < M.
:- table number_not_allergic_gluten/1.
number_not_allergic_gluten(N) :- findall(X, not_allergic_gluten(X), Found), sort(Found, Set), length(Set, N).
fewer_ontray_1_than_not_allergic_gluten :- number_ontray_1(N), number_not_allergic_gluten(M), N < M.
both_todo_served_not_allergic_gluten(X) :- todo_served(X), not_allergic_gluten(X).
:- table number_todo_served_not_allergic_gluten/1.
number_todo_served_not_allergic_gluten(N) :-
    findall(X, both_todo_served_not_allergic_gluten(X), Found),
    sort(Found, Set),
    length(Set, N).
fewer_ontray_1_than_todo_served_not_allergic_gluten :-
    number_ontray_1(N),
    number_todo_served_not_allergic_gluten(M),
    N < M.
fewer_ontray_2_than_not_allergic_gluten :- number_ontray_2(N), number_not_allergic_gluten(M), N < M.
fewer_ontray_2_than_todo_served_not_allergic_gluten :-
    number_ontray_2(N),
    number_todo_served_not_allergic_gluten(M),
    N < M.
fewer_at_1_than_not_allergic_gluten :- number_at_1(N), number_not_allergic_gluten(M), N < M.
fewer_at_1_than_todo_served_not_allergic_gluten :- number_at_1(N), number_todo_served_not_allergic_gluten(M), N < M.
fewer_at_2_than_todo_served_not_allergic_gluten :- number_at_2(N), number_todo_served_not_allergic_gluten(M), N < M.
