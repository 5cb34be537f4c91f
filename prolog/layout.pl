:- module(nppg_layout,
          [ new_layout/4,        % +Table, +Module, +Kinds, +Goal             det
            drop_layout/1,       % +Table                                     det
            layout/4,            % +Table, -Module, -Kinds, -Goal             semidet
            root_count/2,        % +Table, -Count                             det
            template/3,          % +Template, -Term, -Args                    det
            action_roots/5,      % +Table, +GoalValues, +Action, -Kind, -Roots  det
            goal_values/2        % +Table, -Values                            det
          ]).

:- use_module(library(apply), [foldl/4, maplist/4]).
:- use_module(library(lists), [append/2, nth0/3]).
:- use_module(domain, [binding/4]).
:- use_module(guard, [fault/2]).

/** <module> The root variables of an example

The variables that a test starts from: the arguments of the actions of every kind, one kind after the other, and those
of the goal. Tables and packs are about the same ones, which are the layout of their table.
*/

:- dynamic
    layout/4,                    % Table, Module, Kinds, Goal
    roots/5.                     % Table, Action, GoalValues, Kind, Roots

%!  new_layout(+Table, +Module, +Kinds, +Goal) is det.
%
%   Kinds is a list of [Name, Arity], the action templates; Goal is [] or [Name, Arity].

new_layout(Table, Module, Kinds, Goal) :-
    assertz(layout(Table, Module, Kinds, Goal)),
    set_roots(Table, Kinds, Goal).

%   What the root variables are bound to by an action of each kind and by the goal; the arguments of other kinds
%   of actions stay unbound.

set_roots(Table, Kinds, Goal) :-
    maplist(template, Kinds, Actions, Args),
    template(Goal, _, GoalValues),
    append(Args, ActionValues),
    append(ActionValues, GoalValues, Values),
    Roots =.. [roots|Values],
    forall(nth0(Kind, Actions, Action), assertz(roots(Table, Action, GoalValues, Kind, Roots))).

%!  template(+Template, -Term, -Args) is det: [Name, Arity] as a term with unbound arguments; [] for no goal.

template([], [], []).
template([Name, Arity], Template, Args) :-
    functor(Template, Name, Arity),
    Template =.. [_|Args].

drop_layout(Table) :-
    retractall(layout(Table, _, _, _)),
    retractall(roots(Table, _, _, _, _)).

root_count(Table, Count) :-
    layout(Table, _, Kinds, Goal),
    foldl(add_arity, Kinds, 0, Count0),
    (   Goal = [_, Arity]
    ->  Count is Count0+Arity
    ;   Count = Count0
    ).

add_arity([_, Arity], Sum0, Sum) :-
    Sum is Sum0+Arity.

%!  action_roots(+Table, +GoalValues, +Action, -Kind, -Roots) is det.
%
%   The values of the root variables.

action_roots(Table, GoalValues, Action, Kind, Roots) :-
    (   roots(Table, Action, GoalValues, Kind, Roots)
    ->  true
    ;   layout(Table, Module, _, _),
        fault(Module:(action/1), 'gave ~p, for which the language bias has no action template,'-[Action])
    ).

goal_values(Table, Values) :-
    layout(Table, Module, _, Goal),
    (   Goal = [Name, Arity]
    ->  binding(Module, Name, Arity, Values)
    ;   Values = []
    ).
